// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <charconv>
#include <cmath>
#include <csignal>
#include <random>

#include <signal.h>
#include <sys/stat.h>

#include <QDir>
#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const QByteArray header = "distance\tx\ty\tz\tnx\tny\tnz\tface_tests\tnode_visits\tlower\tpromise\n";

/// The cells of each line after the header.
QList<QList<QByteArray>> rowsOf(const QByteArray &out)
{
    QList<QList<QByteArray>> rows;
    if (!out.startsWith(header) || !out.endsWith('\n')) {
        return rows;
    }
    for (const QByteArray &line : out.sliced(header.size()).split('\n')) {
        if (!line.isEmpty()) {
            rows.push_back(line.split('\t'));
        }
    }
    return rows;
}

double number(const QByteArray &cell)
{
    double value = std::nan("");
    const auto [end, status] = std::from_chars(cell.begin(), cell.end(), value);
    return end == cell.end() ? value : std::nan("");
}

/// Three times the most digits that differ.
QByteArray pointText(double x, double y, double z)
{
    return QByteArray::number(x, 'g', 17) + ' ' + QByteArray::number(y, 'g', 17) + ' ' + QByteArray::number(z, 'g', 17)
        + '\n';
}

/// From a point to an axis-aligned box.
double distanceToBox(const std::array<double, 3> &p, const std::array<double, 3> &least,
                     const std::array<double, 3> &greatest)
{
    double square = 0;
    double inside = INFINITY;
    for (std::size_t i = 0; i < 3; ++i) {
        const double beyond = std::max({least[i] - p[i], p[i] - greatest[i], 0.0});
        square += beyond * beyond;
        inside = std::min({inside, p[i] - least[i], greatest[i] - p[i]});
    }
    return square > 0 ? std::sqrt(square) : std::max(inside, 0.0);
}

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

/// The most memory that a process has held, in kB.
qint64 peakMemory(qint64 process)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    const QByteArray text = status.open(QIODevice::ReadOnly) ? status.readAll() : QByteArray();
    return text.mid(text.indexOf("VmHWM:") + 6).trimmed().split(' ').first().toLongLong();
}

}

class TestClosest : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;
    qint64 m_peak = 0;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }

    static Outcome ask(const QString &file, const QByteArray &points, const QStringList &more = {})
    {
        return run(QStringList{"closest", file, "--points", "-"} + more, points);
    }

private Q_SLOTS:
    void initTestCase();
    void anAnswerIsALine();
    void eachColliderSaysWhatItPromises_data();
    void eachColliderSaysWhatItPromises();
    void boxesAtAnyPlaceAreFound_data();
    void boxesAtAnyPlaceAreFound();
    void numbersHaveSeventeenDigits();
    void beyondTheRadiusIsInf();
    void aBudgetIsAdmitted();
    void theToleranceIsKept();
    void theDepthCanBeGiven();
    void linesAreReadAsTheyStand();
    void wrongLinesAreNamed_data();
    void wrongLinesAreNamed();
    void whatStandsBeforeAWrongLineIsAnswered();
    void wrongUsageIsStatus2_data();
    void wrongUsageIsStatus2();
    void badInputIsStatus1();
    void whatIsTooMuchIsRefused_data();
    void whatIsTooMuchIsRefused();
    void aFullDeviceIsStatus3();
    void twoRunsAreTheSame_data();
    void twoRunsAreTheSame();
    void anyLocaleIsTheSame();
    void pipesAreAnsweredAsTheyCome();
    void manyPointsTakeNoMemory();
    void cancellingEndsIt_data();
    void cancellingEndsIt();
};

void TestClosest::initTestCase()
{
    QVERIFY(m_folder.isValid());
    write(path("triangle.obj"), triangle);
    write(path("box.obj"),
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
          "f 1 2 4 3\nf 5 6 8 7\nf 1 2 6 5\nf 3 4 8 7\nf 1 3 7 5\nf 2 4 8 6\n");
    write(path("row.fdo"), "v 1 0 0\nx. \"triangle.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 3\n");
    write(path("boxes.fdo"), "v 2 0 0\nx. \"box.obj\"\nt.p. (p, #, #)\nz<x>. [#, t.1] x\n<$>. z 4\n");
    write(path("bad.fdo"), "v 1 0 0\n<$>. nothing\n");
    write(path("empty.sdo"), "p \"box.obj\" ((3, 0, 0), #, #) 0.5\n");
    write(path("places.sdo"),
          "o \"box.obj\" #\n"
          "o \"box.obj\" ((-2, 0, 0), #, (-1, 1, 1))\n"
          "f \"boxes.fdo\" ((0, 5, 0), #, (1, 3, 0.5))\n"
          "f \"boxes.fdo\" ((0, -5, 0), #, (1, 0, 1))\n"
          "o \"box.obj\" ((0, 0, 7), #, (0, 0, 0))\n"
          "p \"box.obj\" ((30, 0, 0), #, #) 0.5\n");
    QVERIFY(QDir(m_folder.path()).mkdir(QStringLiteral("folder")));
}

void TestClosest::anAnswerIsALine()
{
    const Outcome outcome = ask(path("row.fdo"), "0.25 0.25 -2\n9 0 0\n");
    QVERIFY2(outcome.status == 0, outcome.err);
    QCOMPARE(outcome.err, QByteArray());
    const auto rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0].first(7), (QList<QByteArray>{"2", "0.25", "0.25", "0", "0", "0", "-1"}));
    QCOMPARE(rows[1].first(7), (QList<QByteArray>{"5", "4", "0", "0", "1", "0", "0"}));
    for (const auto &row : rows) {
        QCOMPARE(row.size(), 11);
        QVERIFY(row[7].toInt() >= 1 && row[8].toInt() >= 1);
        QVERIFY(number(row[9]) <= number(row[0]) && number(row[9]) > number(row[0]) - 1e-12);
        QCOMPARE(row[10], QByteArray("exact"));
    }
}

void TestClosest::eachColliderSaysWhatItPromises_data()
{
    QTest::addColumn<QStringList>("more");
    QTest::addColumn<QByteArray>("promise");
    QTest::newRow("default") << QStringList() << QByteArray("exact");
    QTest::newRow("exact") << QStringList{"--collider", "exact"} << QByteArray("exact");
    QTest::newRow("approximate") << QStringList{"--collider", "approximate"} << QByteArray("within 0.001");
    QTest::newRow("tolerance") << QStringList{"--collider", "approximate", "--tolerance", "0.25"}
                               << QByteArray("within 0.25");
    QTest::newRow("bvh") << QStringList{"--collider", "bvh"} << QByteArray("exact");
    QTest::newRow("simple") << QStringList{"--collider", "simple"} << QByteArray("exact");
    QTest::newRow("greedy") << QStringList{"--collider", "greedy"} << QByteArray("upper");
    QTest::newRow("octree") << QStringList{"--collider", "octree"} << QByteArray("none");
}

void TestClosest::eachColliderSaysWhatItPromises()
{
    QFETCH(const QStringList, more);
    QFETCH(const QByteArray, promise);
    const Outcome outcome = ask(path("places.sdo"), "0.5 0.5 -1\n3 3 3\n", more);
    QVERIFY2(outcome.status == 0, outcome.err);
    const auto rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 2);
    for (const auto &row : rows) {
        QCOMPARE(row[10], promise);
        QCOMPARE(row[9] == "0", promise == "upper" || promise == "none");
    }
}

void TestClosest::boxesAtAnyPlaceAreFound_data()
{
    QTest::addColumn<QString>("kind");
    for (const char *kind : {"exact", "bvh", "simple"}) {
        QTest::newRow(kind) << QString::fromLatin1(kind);
    }
}

/// By the closed form of each box in places.sdo.
void TestClosest::boxesAtAnyPlaceAreFound()
{
    QFETCH(const QString, kind);
    std::mt19937_64 random(81);
    std::uniform_real_distribution<double> coordinate(-10, 10);
    QByteArray text;
    std::vector<std::array<double, 3>> points;
    for (int i = 0; i < 300; ++i) {
        points.push_back({coordinate(random), coordinate(random), coordinate(random)});
        text += pointText(points.back()[0], points.back()[1], points.back()[2]);
    }
    const Outcome outcome = ask(path("places.sdo"), text, {"--collider", kind});
    QVERIFY2(outcome.status == 0, outcome.err);
    const auto rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), qsizetype(300));
    for (qsizetype i = 0; i < rows.size(); ++i) {
        const std::array<double, 3> &p = points[static_cast<std::size_t>(i)];
        double least = distanceToBox(p, {0, 0, 0}, {1, 1, 1});
        least = std::min(least, distanceToBox(p, {-3, 0, 0}, {-2, 1, 1}));
        least = std::min(least, distanceToBox(p, {0, 0, 7}, {0, 0, 7}));
        for (int copy = 0; copy <= 4; ++copy) {
            least = std::min(least, distanceToBox(p, {2.0 * copy, 5, 0}, {2.0 * copy + 1, 8, 0.5}));
            least = std::min(least, distanceToBox(p, {2.0 * copy, -5, 0}, {2.0 * copy + 1, -5, 1}));
        }
        QVERIFY2(std::abs(number(rows[i][0]) - least) < 1e-12, rows[i].join(' ') + " but " + QByteArray::number(least));
        QVERIFY(number(rows[i][9]) <= least + 1e-15);
        const double x = number(rows[i][1]) + number(rows[i][0]) * number(rows[i][4]);
        QVERIFY(std::abs(x - p[0]) < 1e-12);
    }
}

void TestClosest::numbersHaveSeventeenDigits()
{
    write(path("tenths.obj"), "v 0.1 0.2 0.7\nv 1 1 1\nv 1 2 1\nf 1 2 3\n");
    const auto rows = rowsOf(ask(path("tenths.obj"), "-1 -1 -1\n").out);
    QCOMPARE(rows.size(), 1);
    qsizetype most = 0;
    for (const QByteArray &cell : rows[0].first(7)) {
        QCOMPARE(cell, QByteArray::number(number(cell), 'g', 17));
        most = std::max<qsizetype>(most, std::ranges::count_if(cell, [](char c) { return c >= '1' && c <= '9'; }));
    }
    QVERIFY(most >= 14); // of 17, of which some are zeros
    QVERIFY(std::abs(number(rows[0][0]) - std::sqrt(1.21 + 1.44 + 2.89)) < 1e-15);
}

void TestClosest::beyondTheRadiusIsInf()
{
    const QByteArray points = "0.25 0.25 2\n0.25 0.25 2.5\n";
    for (const char *kind : {"exact", "approximate", "bvh", "simple", "greedy"}) {
        const auto rows = rowsOf(ask(path("row.fdo"), points, {"--within", "2", "--collider", kind}).out);
        QCOMPARE(rows.size(), 2);
        QCOMPARE(rows[0][0], QByteArray("2"));
        QCOMPARE(rows[1].first(7), (QList<QByteArray>{"inf", "0", "0", "0", "0", "0", "0"}));
        QVERIFY(qstrcmp(kind, "greedy") == 0 ? rows[1][9] == "0" : std::abs(number(rows[1][9]) - 2) < 1e-12);
    }
    const auto rows = rowsOf(ask(path("empty.sdo"), "1 2 3\n").out);
    QCOMPARE(rows.size(), 1);
    QCOMPARE(rows[0], (QList<QByteArray>{"inf", "0", "0", "0", "0", "0", "0", "0", "0", "inf", "exact"}));
}

void TestClosest::aBudgetIsAdmitted()
{
    const QByteArray points = "-11.7 -2.2 -5.9\n";
    const QString file = examples + QStringLiteral("appendix-b.fdo");
    const auto all = rowsOf(ask(file, points).out);
    QCOMPARE(all.size(), 1);
    QVERIFY(all[0][8].toInt() > 10);
    const auto cut = rowsOf(ask(file, points, {"--max-nodes", "10"}).out);
    QCOMPARE(cut.size(), 1);
    QCOMPARE(cut[0][8], QByteArray("10"));
    QVERIFY2(cut[0][10].startsWith("within "), cut[0][10]);
    const double excess = number(cut[0][10].sliced(7));
    QVERIFY(excess > 0 && number(cut[0][0]) <= (1 + excess) * number(all[0][0]) * (1 + 1e-12));
    QVERIFY(number(cut[0][9]) < number(all[0][0]));
    const auto one = rowsOf(ask(file, "0 0 0\n", {"--max-nodes", "1"}).out);
    QCOMPARE(one.value(0).value(10), QByteArray("upper"));
}

void TestClosest::theToleranceIsKept()
{
    std::mt19937_64 random(82);
    std::uniform_real_distribution<double> coordinate(-12, 12);
    QByteArray points;
    for (int i = 0; i < 100; ++i) {
        points += pointText(coordinate(random), coordinate(random), coordinate(random));
    }
    const QString file = examples + QStringLiteral("appendix-b.fdo");
    const auto exact = rowsOf(ask(file, points, {"--depth", "4"}).out);
    const auto rough =
        rowsOf(ask(file, points, {"--depth", "4", "--collider", "approximate", "--tolerance", "0.5"}).out);
    QVERIFY(exact.size() == 100 && rough.size() == 100);
    double worst = 0;
    for (qsizetype i = 0; i < 100; ++i) {
        QVERIFY(number(rough[i][0]) >= number(exact[i][0]) * (1 - 1e-12));
        QVERIFY(number(rough[i][0]) <= number(exact[i][0]) * 1.5 * (1 + 1e-12));
        worst = std::max(worst, number(rough[i][0]) / number(exact[i][0]) - 1);
    }
    QVERIFY(worst > 1e-3); // else nothing is traded
}

void TestClosest::theDepthCanBeGiven()
{
    QCOMPARE(rowsOf(ask(path("row.fdo"), "12 0 0\n", {"--depth", "9"}).out).value(0).value(0), QByteArray("2"));
    // any depth is searched
    const auto deep = rowsOf(ask(examples + "menger.fdo", "3 1.5 1.5\n", {"--depth", "9000000000000000000"}).out);
    QVERIFY(std::abs(number(deep.value(0).value(0)) - 1.5) < 1e-8);
}

void TestClosest::linesAreReadAsTheyStand()
{
    const QByteArray text = "\xEF\xBB\xBF"
                            "0.25 0.25 1\r\n\n \t \r\n\t.25  +25e-2\t2. \n0.25 0.25 1e-400\n0.25 0.25 4";
    write(path("odd.txt"), text);
    const Outcome outcome = run({"closest", path("triangle.obj"), "--points", path("odd.txt")});
    QVERIFY2(outcome.status == 0, outcome.err);
    const auto rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 4);
    QCOMPARE(rows[0][0], QByteArray("1"));
    QCOMPARE(rows[1][0], QByteArray("2"));
    QCOMPARE(rows[2][0], QByteArray("0"));
    QCOMPARE(rows[3][0], QByteArray("4"));
    QCOMPARE(ask(path("triangle.obj"), "").out, header);
}

void TestClosest::wrongLinesAreNamed_data()
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

void TestClosest::wrongLinesAreNamed()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, message);
    write(path("wrong.txt"), text);
    const Outcome outcome = run({"closest", path("triangle.obj"), "--points", path("wrong.txt")});
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.err.startsWith(path("wrong.txt").toUtf8() + message), outcome.err);
    QCOMPARE(outcome.err.count('\n'), 1);
}

void TestClosest::whatStandsBeforeAWrongLineIsAnswered()
{
    const Outcome outcome = ask(path("triangle.obj"), "0 0 1\n0 0 2\n0 0\n0 0 4\n");
    QCOMPARE(outcome.status, 1);
    QVERIFY2(outcome.err.startsWith("<stdin>:3:4: error: "), outcome.err);
    QCOMPARE(rowsOf(outcome.out).size(), 2);
}

void TestClosest::wrongUsageIsStatus2_data()
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

void TestClosest::wrongUsageIsStatus2()
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

void TestClosest::badInputIsStatus1()
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

void TestClosest::whatIsTooMuchIsRefused_data()
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

void TestClosest::whatIsTooMuchIsRefused()
{
    QFETCH(const QStringList, more);
    QFETCH(const QByteArray, message);
    const Outcome outcome = ask(examples + "menger.fdo", "1 2 3\n", more);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains(message), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
}

void TestClosest::aFullDeviceIsStatus3()
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

void TestClosest::twoRunsAreTheSame_data()
{
    QTest::addColumn<QString>("kind");
    for (const char *kind : {"exact", "approximate", "greedy", "octree", "bvh", "simple"}) {
        QTest::newRow(kind) << QString::fromLatin1(kind);
    }
}

void TestClosest::twoRunsAreTheSame()
{
    QFETCH(const QString, kind);
    QByteArray points;
    for (int i = 0; i < 200; ++i) {
        points += pointText(i % 7 - 3, i % 5 - 2, i % 11 - 5); // many ties
    }
    const Outcome first = ask(path("places.sdo"), points, {"--collider", kind});
    QVERIFY2(first.status == 0, first.err);
    QCOMPARE(rowsOf(first.out).size(), 200);
    QCOMPARE(ask(path("places.sdo"), points, {"--collider", kind}).out, first.out);
    // nor do points know of one another
    const Outcome last =
        ask(path("places.sdo"), pointText(199 % 7 - 3, 199 % 5 - 2, 199 % 11 - 5), {"--collider", kind});
    QVERIFY(first.out.endsWith(last.out.sliced(header.size())));
}

void TestClosest::anyLocaleIsTheSame()
{
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert("LC_ALL", "de_DE.UTF-8");
    const QStringList arguments{"closest", path("triangle.obj"), "--points", "-", "--within", "0.5"};
    const Outcome there = run(arguments, "0.1 0.2 0.3\n", german);
    QCOMPARE(there.out, run(arguments, "0.1 0.2 0.3\n").out);
    QCOMPARE(rowsOf(there.out).size(), 1);
}

void TestClosest::pipesAreAnsweredAsTheyCome()
{
    QProcess process;
    process.start(QStringLiteral(ROMANESCO_PROGRAM), {"closest", path("triangle.obj"), "--points", "-"});
    QVERIFY(process.waitForStarted());
    for (int i = 1; i <= 3; ++i) {
        process.write(pointText(0.25, 0.25, i));
        QByteArray answer;
        while (!answer.contains(QByteArray::number(i) + "\t0.25\t") && process.waitForReadyRead(20'000)) {
            answer += process.readAllStandardOutput();
        }
        QVERIFY2(answer.contains(QByteArray::number(i) + "\t0.25\t"), answer);
    }
    process.closeWriteChannel();
    QCOMPARE(outcomeOf(process).status, 0);
}

/// From a pipe that is kept open, so that the process can be looked at before it ends.
void TestClosest::manyPointsTakeNoMemory()
{
    const auto peakAfter = [&](int count, qint64 &answers) {
        QProcess process;
        process.start(QStringLiteral(ROMANESCO_PROGRAM), {"closest", path("triangle.obj"), "--points", "-"});
        QVERIFY2(process.waitForStarted(), "the program does not start");
        for (int i = 0; i < count; ++i) {
            process.write("0.123456789012345 0.234567890123456 0.345678901234567\n");
        }
        answers = -1; // the header
        while (answers < count && process.waitForReadyRead(60'000)) {
            answers += process.readAllStandardOutput().count('\n');
        }
        const qint64 peak = peakMemory(process.processId());
        qInfo("%d points: %lld kB", count, static_cast<long long>(peak));
        process.closeWriteChannel();
        QCOMPARE(outcomeOf(process).status, 0);
        m_peak = peak;
    };
    qint64 answers = 0;
    peakAfter(10'000, answers);
    QCOMPARE(answers, 10'000);
    const qint64 few = m_peak;
    peakAfter(100'000, answers);
    QCOMPARE(answers, 100'000);
    QVERIFY(few > 1'000 && m_peak < few + 3'000);
}

void TestClosest::cancellingEndsIt_data()
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

void TestClosest::cancellingEndsIt()
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

ROMANESCO_TEST(romanesco::test::TestClosest)

#include "testclosest.moc"
