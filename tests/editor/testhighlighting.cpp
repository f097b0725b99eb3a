// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <KSyntaxHighlighting/Repository>
#include <QFileInfo>
#include <QLoggingCategory>
#include <QTemporaryDir>
#include <QTest>

#include "editor/syntax.h"
#include "highlighted.h"
#include "tests/sourcetree.h"

using namespace romanesco;
using namespace romanesco::test;
using KSyntaxHighlighting::Definition;
using KSyntaxHighlighting::Repository;

namespace {

/// What is logged in its lifetime, also what KSyntaxHighlighting holds for debugging only.
class Messages
{
public:
    Messages()
    {
        s_texts.clear();
        QLoggingCategory::setFilterRules(QStringLiteral("kf.syntaxhighlighting=true"));
        m_before = qInstallMessageHandler([](QtMsgType, const QMessageLogContext &context, const QString &text) {
            s_texts += QLatin1String(context.category) + QLatin1String(": ") + text;
        });
    }
    ~Messages()
    {
        qInstallMessageHandler(m_before);
        QLoggingCategory::setFilterRules({});
    }
    Q_DISABLE_COPY_MOVE(Messages)

    [[nodiscard]] QString all() const { return s_texts.join(QLatin1Char('\n')); }

private:
    static inline QStringList s_texts;
    QtMessageHandler m_before;
};

}

/// Golden: every sample in tests/golden/highlighting against the colours written beside it. tests/golden/accept writes
/// them anew.
class TestHighlighting : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void definitionsAreFoundByFileName_data();
    void definitionsAreFoundByFileName();
    void definitionsLoadWithoutAMessage_data();
    void definitionsLoadWithoutAMessage();
    void badDefinitionsWouldHaveSaidSo_data();
    void badDefinitionsWouldHaveSaidSo();
    void samplesGetTheirColours_data();
    void samplesGetTheirColours();
    void aLineIsColouredByItselfAlone_data();
    void aLineIsColouredByItselfAlone();
};

void TestHighlighting::definitionsAreFoundByFileName_data()
{
    QTest::addColumn<QString>("fileName");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("type");
    QTest::newRow("fdo") << QStringLiteral("folder/a b.fdo") << QStringLiteral("Romanesco Fractal")
                         << QStringLiteral("text/x-romanesco-fdo");
    QTest::newRow("sdo") << QStringLiteral("folder/a b.sdo") << QStringLiteral("Romanesco Scene")
                         << QStringLiteral("text/x-romanesco-sdo");
}

void TestHighlighting::definitionsAreFoundByFileName()
{
    QFETCH(const QString, fileName);
    QFETCH(const QString, type);
    const Definition definition = syntaxFor(fileName);
    QVERIFY(definition.isValid());
    QTEST(definition.name(), "name");
    QCOMPARE(definition.mimeTypes(), QStringList{type});
    QCOMPARE(Repository().definitionForMimeType(type), definition);
    QCOMPARE(definition.singleLineCommentMarker(), QStringLiteral("#"));
}

void TestHighlighting::definitionsLoadWithoutAMessage_data()
{
    definitionsAreFoundByFileName_data();
}

void TestHighlighting::definitionsLoadWithoutAMessage()
{
    QFETCH(const QString, fileName);
    const Messages messages;
    const Repository repository; // one of its own, so that nothing has been loaded before
    const Definition definition = repository.definitionForFileName(fileName);
    for (const QString &path : samples(QFileInfo(fileName).suffix())) {
        QVERIFY(!highlighted(definition, linesOf(path)).isEmpty());
    }
    QCOMPARE(messages.all(), QString());
}

void TestHighlighting::badDefinitionsWouldHaveSaidSo_data()
{
    QTest::addColumn<QByteArray>("good");
    QTest::addColumn<QByteArray>("bad");
    QTest::newRow("context") << QByteArray("#pop!Depth") << QByteArray("#pop!Nowhere");
    QTest::newRow("attribute") << QByteArray("attribute=\"Index\"") << QByteArray("attribute=\"Nowhere\"");
    QTest::newRow("expression") << QByteArray("&lt;\\s*+\\$") << QByteArray("(Nowhere");
    QTest::newRow("definition") << QByteArray("##Comments") << QByteArray("##Nowhere");
}

/// That nothing is said counts only where something would be: the log may be off, or may have moved.
void TestHighlighting::badDefinitionsWouldHaveSaidSo()
{
    QFETCH(const QByteArray, good);
    QFETCH(const QByteArray, bad);
    QByteArray definition = bytesOf(test::sourcePath("resources/syntax/fdo.xml"));
    QVERIFY(definition.contains(good));
    definition.replace(good, bad).replace("Romanesco Fractal", "Bad");
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir(QStringLiteral("syntax")));
    QFile file(folder.filePath(QStringLiteral("syntax/bad.xml")));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(definition) == definition.size());
    file.close();

    const Messages messages;
    Repository repository;
    repository.addCustomSearchPath(folder.path());
    QVERIFY(repository.definitionForName(QStringLiteral("Bad")).isValid());
    highlighted(repository.definitionForName(QStringLiteral("Bad")), {QStringLiteral("<$>. x 6")});
    QVERIFY2(messages.all().contains(QLatin1String("Nowhere")), qPrintable(messages.all()));
}

void TestHighlighting::samplesGetTheirColours_data()
{
    QTest::addColumn<QString>("path");
    for (const QString &path : samples()) {
        QTest::newRow(qPrintable(QFileInfo(path).fileName())) << path;
    }
}

void TestHighlighting::samplesGetTheirColours()
{
    QFETCH(const QString, path);
    const QByteArray found = highlighted(syntaxFor(path), linesOf(path)).toUtf8();
    const QString expectedPath = path + QStringLiteral(".expected");
    if (qEnvironmentVariableIsSet("ROMANESCO_ACCEPT")) {
        QFile file(expectedPath);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(found), found.size());
        return;
    }
    const QList<QByteArray> expectedLines = bytesOf(expectedPath).split('\n');
    const QList<QByteArray> foundLines = found.split('\n');
    for (qsizetype i = 0; i < std::min(expectedLines.size(), foundLines.size()); ++i) {
        QCOMPARE(foundLines[i], expectedLines[i]);
    }
    QCOMPARE(foundLines.size(), expectedLines.size());
}

void TestHighlighting::aLineIsColouredByItselfAlone_data()
{
    samplesGetTheirColours_data();
}

/// Nothing goes on over lines, so a slip colours no other line.
void TestHighlighting::aLineIsColouredByItselfAlone()
{
    QFETCH(const QString, path);
    LineHighlighter all(syntaxFor(path));
    for (const QString &line : linesOf(path)) {
        QCOMPARE(all.described(line), LineHighlighter(syntaxFor(path)).described(line));
    }
}

QTEST_GUILESS_MAIN(TestHighlighting)

#include "testhighlighting.moc"
