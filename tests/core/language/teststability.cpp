// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QDir>
#include <QFile>
#include <QTest>

#include "core/formats/fdoreader.h"
#include "core/language/stability.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

Diagnostics hintsOf(const std::string &text)
{
    const FdoDocument document(text);
    const FdoResult result = describeFdo(document.syntax, document.model);
    return result.description ? stabilityHints(document, *result.description)
                              : Diagnostics{{DiagnosticCode::NoResult, {0, 0}, {}}};
}

/// "code at words", joined.
QString told(const std::string &text)
{
    QStringList found;
    for (const Diagnostic &diagnostic : hintsOf(text)) {
        const std::string words = text.substr(diagnostic.range.begin, diagnostic.range.length());
        found += QString::fromStdString(std::string(name(diagnostic.code)) + " at " + words);
    }
    return found.join(QStringLiteral(", "));
}

const char *const start = "half .5 .5 .5\none 1 1 1\nbig 1.25 1 1\nflat .5 0 .5\nmirror -.5 .5 .5\nturn 0 0 30\n"
                          "quarter 0 0 90\nlock 10 89.8 0\nstretch .5 .25 .25\naside 1 0 0\ntwice 2 2 2\n"
                          "s.k. (#, #, k)\nr.a. (#, a, half)\nm. (aside, #, #)\nx. \"x.obj\"\n";

}

class TestStability : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tells_data();
    void tells();
    void examplesAreStable();
    void thousandsOfSetsAreToldOneByOne();
};

void TestStability::tells_data()
{
    QTest::addColumn<QByteArray>("lines");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char *lines, const char *expected) {
        QTest::newRow(lines) << QByteArray(lines) << QString::fromUtf8(expected);
    };
    // convergence, which only iterations need
    row("z<x>. [s.half] x\n<$>. z 6", "");
    row("<$>. [m, s.big] x", "");
    row("z<x>. [#, s.half] x\n<$>. z 6", "");
    row("z<x>. [m] x\n<$>. z 6", "does-not-converge at m");
    row("z<x>. [m] x\n<$>. [m] z 1", "");
    row("z<x>. [s.half, s.big] x\n<$>. z 6", "does-not-converge at s.big");
    row("z<x>. [m] [s.half] x\n<$>. z 6", "");                          // the pass as a whole does
    row("z<x>. [m] [#, s.half] x\n<$>. z 6", "does-not-converge at m"); // but not where # is taken
    row("z<x>. [#, m] [s.half] x\n<$>. z 6", "");
    row("z<x>. [#] x\n<$>. z 6", "");
    row("w<x>. [s.half] x\nz<x>. [s.twice] w 100\n<$>. z 2", "beyond-double at 2"); // w is passed through often
    row("w<x>. [s.half] x\nz<x>. [s.twice] w 1\n<$>. z 2", "does-not-converge at s.twice");
    // maps
    row("<$>. [s.flat] x", "singular at s.flat");
    row("<$>. [s.half, s.flat, s.flat] x", "singular at s.flat");
    row("<$>. [s.mirror] x", "mirrored at s.mirror");
    row("<$>. [s.half] x\nunused. [s.mirror] x", "");
    row("<$>. [r.lock] x", "near-gimbal at r.lock");
    row("<$>. [r.turn] x", "");
    // an uneven scale outside a turn; not inside it, and not where the turn goes along the axes
    row("<$>. [s.stretch] [r.turn] x", "sheared at s.stretch");
    row("<$>. [r.turn] [s.stretch] x", "");
    row("<$>. [s.stretch] [r.quarter] x", "");
    row("z<x>. [r.turn] [s.stretch] x\n<$>. z 2", "sheared at s.stretch"); // the next pass is inside
    row("z<x>. [r.turn] [s.stretch] x\n<$>. z 1", "");
    row("<$>. [s.half] [r.turn] x", "");
    // depth: 0.5^54 < 1e-16
    row("z<x>. [s.half] x\n<$>. z 53", "");
    row("z<x>. [s.half] x\n<$>. z 54", "beyond-double at 54");
    row("z<x>. [s.half] [#, s.half] x\n<$>. z 27", "beyond-double at 27");
    row("y<x>. [#, s.half] x\nz<x>. [#, m] y 40\n<$>. z 2", "does-not-converge at m, beyond-double at 2");
}

void TestStability::tells()
{
    QFETCH(QByteArray, lines);
    QFETCH(QString, expected);
    QCOMPARE(told(start + lines.toStdString()), expected);
}

/// At most hints: a warning in a text that is shown to newcomers would be a fault of the text.
void TestStability::examplesAreStable()
{
    const QDir folder(test::sourcePath("resources/examples"));
    for (const QFileInfo &info : folder.entryInfoList({QStringLiteral("*.fdo")})) {
        QFile file(info.filePath());
        QVERIFY(file.open(QIODevice::ReadOnly));
        for (const Diagnostic &diagnostic : hintsOf(file.readAll().toStdString())) {
            QVERIFY2(diagnostic.severity() == Severity::Hint,
                     qPrintable(info.fileName() + QStringLiteral(": ") + QString::fromStdString(diagnostic.message())));
        }
    }
}

void TestStability::thousandsOfSetsAreToldOneByOne()
{
    std::string text = start;
    text += "o0. x\n";
    constexpr std::size_t count = 20'000;
    for (std::size_t i = 1; i <= count; ++i) {
        text += "o" + std::to_string(i) + ". [s.mirror] o" + std::to_string(i - 1) + '\n';
    }
    text += "<$>. o" + std::to_string(count) + '\n';
    QCOMPARE(hintsOf(text).size(), count);
}

}

ROMANESCO_TEST(romanesco::test::TestStability)

#include "teststability.moc"
