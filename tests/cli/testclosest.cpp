// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <QTest>

#include "tests/cli/closesttest.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

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

/// The most memory that a process has held, in kB.
qint64 peakMemory(qint64 process)
{
    QFile status(QStringLiteral("/proc/%1/status").arg(process));
    const QByteArray text = status.open(QIODevice::ReadOnly) ? status.readAll() : QByteArray();
    return text.mid(text.indexOf("VmHWM:") + 6).trimmed().split(' ').first().toLongLong();
}

}

/// What is nearest to points, and how it is told.
class TestClosest : public ClosestTest
{
    Q_OBJECT

    qint64 m_peak = 0;

private Q_SLOTS:
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
    void twoRunsAreTheSame_data();
    void twoRunsAreTheSame();
    void anyLocaleIsTheSame();
    void pipesAreAnsweredAsTheyCome();
    void manyPointsTakeNoMemory();
};

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

}

ROMANESCO_TEST(romanesco::test::TestClosest)

#include "testclosest.moc"
