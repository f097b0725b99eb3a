// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <filesystem>
#include <set>
#include <string>

#include <QDir>
#include <QFile>
#include <QTest>

#include "core/formats/fdoreader.h"
#include "core/formats/sdoreader.h"
#include "core/text/linemap.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

QString folder()
{
    return test::sourcePath("tests/golden/diagnostics");
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// The samples of both languages.
QStringList samples()
{
    return QDir(folder()).entryList({QStringLiteral("*.fdo"), QStringLiteral("*.sdo")}, QDir::Files, QDir::Name);
}

std::string textOf(const QString &sample)
{
    return bytesOf(folder() + QLatin1Char('/') + sample).toStdString();
}

struct Remarks {
    Diagnostics diagnostics;
    bool hasMeaning = false;
};

/// Reads in the language that a sample's name says.
Remarks remarksOn(const QString &sample, const std::string &text)
{
    if (sample.endsWith(QLatin1String(".sdo"))) {
        SdoResult result = readSdo(text);
        return {std::move(result.diagnostics), result.description.has_value()};
    }
    FdoResult result = readFdo(text);
    return {std::move(result.diagnostics), result.description.has_value()};
}

/// The fix with what it makes of the line, and the notes.
QByteArray asides(const Diagnostic &diagnostic, const std::string &text)
{
    QByteArray out;
    if (diagnostic.fix) {
        const std::string fixed = applied(text, diagnostic.fix->edits);
        const LineMap lines(fixed);
        const std::size_t line = lines.lineAt(diagnostic.fix->edits.front().range.begin);
        out += "# expect:     fix: " + QByteArray::fromStdString(diagnostic.fix->title) + ": "
            + QByteArray::fromStdString(std::string(lines.lineText(line))) + '\n';
    }
    for (const Note &note : diagnostic.notes) {
        out += "# expect:     note: " + QByteArray::number(note.position.line) + ':'
            + QByteArray::number(note.position.column) + ": " + QByteArray::fromStdString(note.message()) + '\n';
    }
    return out;
}

/// What is said, as comments at the end of a sample: `# expect: 3:8-9 error …`, with fixes and notes below.
QByteArray expectations(const QString &sample, const std::string &text)
{
    const Remarks remarks = remarksOn(sample, text);
    const LineMap lines(text);
    QByteArray out;
    for (const Diagnostic &diagnostic : remarks.diagnostics) {
        const TextPosition begin = lines.position(diagnostic.range.begin);
        const TextPosition end = lines.position(diagnostic.range.end);
        out += "# expect: " + QByteArray::number(begin.line) + ':' + QByteArray::number(begin.column) + '-'
            + (end.line == begin.line ? QByteArray::number(end.column) : QByteArray("another line")) + ' '
            + name(diagnostic.severity()).data() + ' ' + name(diagnostic.code).data() + ": "
            + QByteArray::fromStdString(diagnostic.message()) + '\n';
        out += asides(diagnostic, text);
    }
    return out + (remarks.hasMeaning ? "# expect: means something\n" : "# expect: means nothing\n");
}

/// Where the expectations begin in a sample; its end where there are none.
std::size_t bodySize(const std::string &text)
{
    if (text.starts_with("# expect:")) {
        return 0;
    }
    const std::size_t at = text.find("\n# expect:");
    return at == text.npos ? text.size() : at + 1;
}

}

/// Golden: every sample in tests/golden/diagnostics against the remarks at its end. tests/golden/accept writes them anew.
class TestDiagnostics : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesGetTheirRemarks_data();
    void samplesGetTheirRemarks();
    void aLineGetsOneError();
    void fixesPutRight();
    void everyDiagnosticOfTheLanguagesOccurs();
};

void TestDiagnostics::samplesGetTheirRemarks_data()
{
    QTest::addColumn<QString>("sample");
    for (const QString &sample : samples()) {
        QTest::newRow(qPrintable(sample)) << sample;
    }
}

void TestDiagnostics::samplesGetTheirRemarks()
{
    QFETCH(QString, sample);
    const std::string text = textOf(sample);
    const std::string body = text.substr(0, bodySize(text));
    const QByteArray found = expectations(sample, text);
    if (qEnvironmentVariableIsSet("ROMANESCO_ACCEPT")) {
        // what is said of the end of the text moves with the number of expectations
        QByteArray accepted = found;
        for (int i = 0; i < 3; ++i) {
            accepted = expectations(sample, body + accepted.toStdString());
        }
        QFile file(folder() + QLatin1Char('/') + sample);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QVERIFY(file.write(QByteArray::fromStdString(body) + accepted) > 0);
        return;
    }
    const QList<QByteArray> expectedLines = QByteArray::fromStdString(text.substr(body.size())).split('\n');
    const QList<QByteArray> foundLines = found.split('\n');
    for (qsizetype i = 0; i < std::min(expectedLines.size(), foundLines.size()); ++i) {
        QCOMPARE(foundLines[i], expectedLines[i]);
    }
    QCOMPARE(foundLines.size(), expectedLines.size());
}

/// One slip, one message.
void TestDiagnostics::aLineGetsOneError()
{
    for (const QString &sample : samples()) {
        const std::string text = textOf(sample);
        const LineMap lines(text);
        std::set<std::size_t> seen;
        for (const Diagnostic &diagnostic : remarksOn(sample, text).diagnostics) {
            const std::size_t line = lines.position(diagnostic.range.begin).line;
            if (diagnostic.isError()) {
                QVERIFY2(seen.insert(line).second, qPrintable(sample + QLatin1Char(':') + QString::number(line)));
            }
        }
    }
}

/// After a fix the same is not said again of the same place.
void TestDiagnostics::fixesPutRight()
{
    int fixes = 0;
    for (const QString &sample : samples()) {
        const std::string text = textOf(sample);
        for (const Diagnostic &diagnostic : remarksOn(sample, text).diagnostics) {
            if (!diagnostic.fix) {
                continue;
            }
            ++fixes;
            const std::string fixed = applied(text, diagnostic.fix->edits);
            for (const Diagnostic &left : remarksOn(sample, fixed).diagnostics) {
                QVERIFY2(left.message() != diagnostic.message() || left.range.begin != diagnostic.range.begin,
                         qPrintable(sample + QStringLiteral(": ") + QString::fromStdString(left.message())));
            }
        }
    }
    QVERIFY(fixes > 100);
}

/// So that a new message comes with a sample. Left out are those that need a mesh or bytes that are no text, and what
/// core/language has to say.
void TestDiagnostics::everyDiagnosticOfTheLanguagesOccurs()
{
    std::set<DiagnosticCode> missing;
    for (int i = 0; i < static_cast<int>(DiagnosticCode::ObjTooFewCoordinates); ++i) {
        missing.insert(static_cast<DiagnosticCode>(i));
    }
    for (const DiagnosticCode elsewhere :
         {DiagnosticCode::NotUtf8, DiagnosticCode::CannotRead, DiagnosticCode::BadMesh, DiagnosticCode::FileRemarks,
          DiagnosticCode::MeshWithoutFaces, DiagnosticCode::Overflow}) {
        missing.erase(elsewhere);
    }
    missing.erase(missing.find(DiagnosticCode::DoesNotConverge), std::next(missing.find(DiagnosticCode::NearGimbal)));
    for (const QString &sample : samples()) {
        for (const Diagnostic &diagnostic : remarksOn(sample, textOf(sample)).diagnostics) {
            missing.erase(diagnostic.code);
            for (const Note &note : diagnostic.notes) {
                missing.erase(note.code);
            }
        }
    }
    QByteArray names;
    for (const DiagnosticCode code : missing) {
        names += QByteArray(name(code).data()) + ' ';
    }
    QCOMPARE(names, QByteArray());
}

}

ROMANESCO_TEST(romanesco::test::TestDiagnostics)

#include "testdiagnostics.moc"
