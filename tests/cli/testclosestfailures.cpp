// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <csignal>

#include <signal.h>

#include <QElapsedTimer>
#include <QTest>

#include "tests/cli/closesttest.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

bool catches(qint64 process, int signal)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    if (!status.open(QIODevice::ReadOnly)) {
        return false;
    }
    const QByteArray text = status.readAll();
    const QByteArray caught = text.mid(text.indexOf("SigCgt:") + 7).trimmed().left(16);
    return (caught.toULongLong(nullptr, 16) >> (signal - 1) & 1) != 0;
}

}

/// Points, files and arguments that are wrong, what is too much, and an end before the end.
class TestClosestFailures : public ClosestTest
{
    Q_OBJECT

private Q_SLOTS:
    void wrongLinesAreNamed_data();
    void wrongLinesAreNamed();
    void whatStandsBeforeAWrongLineIsAnswered();
    void wrongUsageIsStatus2_data();
    void wrongUsageIsStatus2();
    void badInputIsStatus1();
    void whatIsTooMuchIsRefused_data();
    void whatIsTooMuchIsRefused();
    void aFullDeviceIsStatus3();
    void cancellingEndsIt_data();
    void cancellingEndsIt();
};

void TestClosestFailures::wrongLinesAreNamed_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *name, const QByteArray &text, const char *message) {
        QTest::newRow(name) << text << QByteArray(message);
    };
    row("two numbers", "1 2 3\n\n4 5 \n", ":3:4: error: a point is three numbers, x y z; here one is missing\n");
    row("one number", "4\n", ":1:2: error: a point is three numbers, x y z; here two are missing\n");
    row("four numbers", "1 2 3 4\n", ":1:7: error: \"4\" is a fourth; a point is three numbers, x y z\n");
    row("a word", "1 2 3\n1 zwei 3\n", ":2:3: error: \"zwei\" is no number; a point is three of them, x y z\n");
    row("commas", "1, 2, 3\n", ":1:1: error: \"1,\" is no number");
    row("a decimal comma", "1 2,5 3\n", ":1:3: error: \"2,5\" is no number");
    row("nan", "1 nan 3\n", ":1:3: error: \"nan\" is no number");
    row("infinity", "1 2 -inf\n", ":1:5: error: \"-inf\" is no number");
    row("hexadecimal", "0x10 2 3\n", ":1:1: error: \"0x10\" is no number");
    row("beyond doubles", "1 2 1e999\n", ":1:5: error: \"1e999\" is too far away (at most 1e+140 in size)\n");
    row("too far", "1 -2e140 1\n", ":1:3: error: \"-2e140\" is too far away");
    row("columns are code points", "\xC3\xA4 1 2\n", ":1:1: error: \"\xC3\xA4\" is no number");
    row("columns after code points", "1 \xC3\xA4\xC3\xA4 x\n", ":1:3: error: \"\xC3\xA4\xC3\xA4\" is no number");
    row("bytes that are no text", "1 \xFF\x1B[2J 3\n", ":1:3: error: \"??[2J\" is no number");
    row("a long word", "1 2 " + QByteArray(99, '7') + "x\n",
        ":1:5: error: \"7777777777777777777777777777777777777777...\" is no number");
    row("a long line", "1 2 3\n" + QByteArray(5'000, ' ') + "\n", ":2:1: error: the line is longer than 4096 bytes");
    row("zeros without end", QByteArray(10'000'000, '\0'), ":1:1: error: the line is longer than 4096 bytes");
}

void TestClosestFailures::wrongLinesAreNamed()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, message);
    write(path("wrong.txt"), text);
    const Outcome outcome = run({"closest", path("triangle.obj"), "--points", path("wrong.txt")});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.err.startsWith(path("wrong.txt").toUtf8() + message), outcome.err);
    QCOMPARE(outcome.err.count('\n'), 1);
}

void TestClosestFailures::whatStandsBeforeAWrongLineIsAnswered()
{
    const Outcome outcome = ask(path("triangle.obj"), "0 0 1\n0 0 2\n0 0\n0 0 4\n");
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.err.startsWith("<stdin>:3:4: error: "), outcome.err);
    QCOMPARE(rowsOf(outcome.out).size(), 2);
}

void TestClosestFailures::wrongUsageIsStatus2_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *name, const QStringList &arguments, const char *message) {
        QTest::newRow(name) << arguments << QByteArray(message);
    };
    row("no points", {"row.fdo"}, "closest needs --points PTS");
    row("no file", {"--points", "p.txt"}, "takes one FILE");
    row("both from stdin", {"-", "--points", "-"}, "stdin can be read once only");
    row("unknown collider", {"row.fdo", "--points", "p.txt", "--collider", "magic"}, "bvh or simple, not \"magic\"");
    row("tolerance of exact", {"row.fdo", "--points", "p.txt", "--tolerance", "0.1"},
        "only --collider approximate has a tolerance");
    row("negative tolerance", {"row.fdo", "--points", "p.txt", "--collider", "approximate", "--tolerance", "-0.1"},
        "from 0 on, not \"-0.1\"");
    row("tolerance in words", {"row.fdo", "--points", "p.txt", "--collider", "approximate", "--tolerance", "few"},
        "from 0 on, not \"few\"");
    row("negative radius", {"row.fdo", "--points", "p.txt", "--within", "-1"}, "--within takes a number from 0 on");
    row("radius in words", {"row.fdo", "--points", "p.txt", "--within", "far"}, "from 0 on, not \"far\"");
    row("no nodes", {"row.fdo", "--points", "p.txt", "--max-nodes", "0"}, "from 1 on, not \"0\"");
    row("part of a node", {"row.fdo", "--points", "p.txt", "--max-nodes", "1.5"}, "from 1 on, not \"1.5\"");
    row("nodes of simple", {"row.fdo", "--points", "p.txt", "--collider", "simple", "--max-nodes", "5"},
        "only --collider exact and approximate have a limit of nodes");
    row("depth of a mesh", {"triangle.obj", "--points", "p.txt", "--depth", "3"}, "--depth needs");
}

void TestClosestFailures::wrongUsageIsStatus2()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, message);
    QProcess process;
    process.setWorkingDirectory(m_folder.path());
    process.start(QStringLiteral(ROMANESCO_PROGRAM), QStringList{"closest"} + arguments);
    process.closeWriteChannel();
    const Outcome outcome = outcomeOf(process);
    QVERIFY2(outcome.err.contains(message), outcome.err);
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.out, QByteArray());
}

void TestClosestFailures::badInputIsStatus1()
{
    const Outcome bad = ask(path("bad.fdo"), "1 2 3\n");
    QCOMPARE(bad.status, 1);
    QVERIFY2(bad.err.contains("bad.fdo:2:6: error: "), bad.err);
    const Outcome missing = run({"closest", path("row.fdo"), "--points", path("gone.txt")});
    QCOMPARE(missing.status, 1);
    QVERIFY2(missing.err.contains("cannot read ") && missing.err.contains("gone.txt: no such file"), missing.err);
    const Outcome folder = run({"closest", path("row.fdo"), "--points", path("folder")});
    QCOMPARE(folder.status, 1);
    QVERIFY2(folder.err.contains("folder: it is a directory"), folder.err);
}

void TestClosestFailures::whatIsTooMuchIsRefused_data()
{
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QByteArray>("message");
    const QByteArray deep = "menger.fdo: 64000000 copies of 12 faces are too many (at most 100000000 faces)\n";
    QTest::newRow("bvh") << QStringList{"--collider", "bvh", "--depth", "6"} << deep;
    QTest::newRow("simple") << QStringList{"--collider", "simple", "--depth", "6"} << deep;
    QTest::newRow("octree") << QStringList{"--collider", "octree", "--depth", "5"} << QByteArray("menger.fdo: ");
    QTest::newRow("greedy") << QStringList{"--collider", "greedy", "--depth", "1000001"}
                            << QByteArray("(at most 1000000)\n");
}

void TestClosestFailures::whatIsTooMuchIsRefused()
{
    QFETCH(const QStringList, more);
    QFETCH(const QByteArray, message);
    const Outcome outcome = ask(examples + "menger.fdo", "1 2 3\n", more);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains(message), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
}

void TestClosestFailures::aFullDeviceIsStatus3()
{
    QProcess process;
    process.setStandardOutputFile(QStringLiteral("/dev/full"));
    process.start(QStringLiteral(ROMANESCO_PROGRAM), {"closest", path("row.fdo"), "--points", "-"});
    process.write("1 2 3\n");
    process.closeWriteChannel();
    const Outcome outcome = outcomeOf(process);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("disk full"), outcome.err);
}

void TestClosestFailures::cancellingEndsIt_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("hasPoint");
    const QString deep = examples + QStringLiteral("menger.fdo");
    QTest::newRow("waiting for points") << QStringList{deep} << SIGINT << false;
    QTest::newRow("SIGTERM") << QStringList{deep} << SIGTERM << false;
    QTest::newRow("in a long query") << QStringList{deep, "--depth", "5", "--collider", "simple"} << SIGINT << true;
    QTest::newRow("building") << QStringList{deep, "--depth", "5", "--collider", "bvh"} << SIGINT << true;
}

void TestClosestFailures::cancellingEndsIt()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const int, signal);
    QFETCH(const bool, hasPoint);
    QProcess process;
    process.start(QStringLiteral(ROMANESCO_PROGRAM), QStringList{"closest"} + arguments + QStringList{"--points", "-"});
    QVERIFY(process.waitForStarted());
    if (hasPoint) {
        process.write("20 30 40\n");
    }
    QVERIFY(QTest::qWaitFor([&] { return catches(process.processId(), signal); }, 30'000));
    QTest::qWait(300);
    QCOMPARE(process.state(), QProcess::Running);
    QElapsedTimer timer;
    timer.start();
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), signal), 0);
    const Outcome outcome = outcomeOf(process);
    qInfo("ended after %lld ms", static_cast<long long>(timer.elapsed()));
    QVERIFY(!outcome.isCrash);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("cancelled"), outcome.err);
    QVERIFY(outcome.out == header || outcome.out.isEmpty());
    QVERIFY(timer.elapsed() < 5'000);
}

}

ROMANESCO_TEST(romanesco::test::TestClosestFailures)

#include "testclosestfailures.moc"
