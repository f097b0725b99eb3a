// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <cmath>

#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/program.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const QByteArray header = "step,time,ball,x,y,z,vx,vy,vz,radius,contacts,face_tests";

struct Row {
    int step;
    double time;
    int ball;
    double y;
    double vx;
    double vy;
    double radius;
    int contacts;
};

/// Empty where a row is not as it should be.
QList<Row> rowsOf(const QByteArray &out)
{
    QList<Row> rows;
    QList<QByteArray> lines = out.split('\n');
    if (lines.takeFirst() != header || lines.takeLast() != "") {
        return {};
    }
    for (const QByteArray &line : lines) {
        const QList<QByteArray> cells = line.split(',');
        bool isGood = cells.size() == 12;
        for (const QByteArray &cell : cells) {
            bool isNumber = false;
            (void)cell.toDouble(&isNumber);
            isGood = isGood && isNumber;
        }
        if (!isGood) {
            return {};
        }
        rows.push_back({cells[0].toInt(), cells[1].toDouble(), cells[2].toInt(), cells[4].toDouble(),
                        cells[6].toDouble(), cells[7].toDouble(), cells[9].toDouble(), cells[10].toInt()});
    }
    return rows;
}

QByteArray stateOf(const QByteArray &err)
{
    const qsizetype from = err.indexOf("state ");
    return from < 0 ? QByteArray("no state") : err.mid(from + 6, 16);
}

}

class TestSimulate : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    Outcome simulate(const QStringList &arguments, const QByteArray &input = {}) const
    {
        return run(QStringList{"simulate"} + arguments, input);
    }

private Q_SLOTS:
    void initTestCase();
    void eachBallHasARowAtEachStep();
    void ballsFallAndRest();
    void theScenesBallsAreTaken();
    void theSameInputIsTheSameBytes_data();
    void theSameInputIsTheSameBytes();
    void radiiShrink();
    void theDissertationsBallsTunnel();
    void recordingsAreReplayed();
    void recordingsDropBallsAndChangeColliders();
    void recordingsOfOtherScenesAreRefused();
    void brokenRecordingsAreStatus1_data();
    void brokenRecordingsAreStatus1();
    void stepsAreClampedWithAWarning();
    void wrongUsageIsStatus2_data();
    void wrongUsageIsStatus2();
    void badInputIsStatus1();
    void aFullDeviceIsStatus3();
};

void TestSimulate::initTestCase()
{
    QVERIFY(m_folder.isValid());
    write(path("floor.obj"), "v -5 0 -5\nv 5 0 -5\nv -5 0 5\nv 5 0 5\nf 1 2 4 3\n");
    write(path("ball.obj"), "v 0 0 1\nv 0.5 0 0\nv 0 0.5 0\nf 1 2 3\n");
    write(path("point.obj"), "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
    write(path("one.sdo"), "o \"floor.obj\" #\np \"ball.obj\" ((0, 1, 0), #, (0.1, 0.1, 0.1)) 0\n");
    write(path("two.sdo"),
          "o \"floor.obj\" #\n"
          "p \"ball.obj\" ((0, 1, 0), #, (0.1, 0.1, 0.1)) 0.5\n"
          "p \"ball.obj\" ((2, 1, 0), #, (0.1, 0.2, 0.3)) 1 (1, 0, -2)\n");
    write(path("fast.sdo"), "o \"floor.obj\" #\np \"ball.obj\" ((0, 1.2, 0), #, (0.01, 0.01, 0.01)) 1 (0, -100, 0)\n");
    write(path("point.sdo"), "p \"point.obj\" # 0.5\n");
}

void TestSimulate::eachBallHasARowAtEachStep()
{
    const Outcome outcome = simulate({path("two.sdo"), "--seconds", "0.1", "--dt", "0.01"});
    QCOMPARE(outcome.status, 0);
    const QList<Row> rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 22);
    for (int i = 0; i < rows.size(); ++i) {
        QCOMPARE(rows[i].step, i / 2);
        QCOMPARE(rows[i].ball, i % 2);
        QCOMPARE(rows[i].time, i / 2 * 0.01);
        QVERIFY(std::abs(rows[i].y - (1 - 4.9 * rows[i].time * rows[i].time)) < 1e-12);
    }
    QCOMPARE(stateOf(outcome.err).size(), 16);
}

void TestSimulate::ballsFallAndRest()
{
    const Outcome outcome = simulate({path("one.sdo"), "--seconds", "2"});
    const QList<Row> rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 481);
    const double fall = std::sqrt(2 * 0.9 / 9.8);
    for (const Row &row : rows) {
        if (row.time > fall + 0.05) {
            QVERIFY(std::abs(row.y - 0.1) < 2e-5 && row.vy == 0 && row.contacts == 1);
        }
    }
}

/// Their radius is that of the farthest vertex, after their scale.
void TestSimulate::theScenesBallsAreTaken()
{
    const QList<Row> rows = rowsOf(simulate({path("two.sdo"), "--seconds", "0"}).out);
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0].radius, 0.1);
    QCOMPARE(rows[1].radius, 0.3);
    QCOMPARE(rows[1].vx, 1.0);
}

void TestSimulate::theSameInputIsTheSameBytes_data()
{
    QTest::addColumn<QStringList>("more");
    QTest::newRow("plain") << QStringList{};
    QTest::newRow("shrinking") << QStringList{"--shrink", "0.5"};
    QTest::newRow("approximate") << QStringList{"--collider", "approximate", "--tolerance", "0.01"};
    QTest::newRow("bvh") << QStringList{"--collider", "bvh"};
    QTest::newRow("greedy") << QStringList{"--collider", "greedy"};
    QTest::newRow("as in the dissertation") << QStringList{"--as-dissertation"};
}

void TestSimulate::theSameInputIsTheSameBytes()
{
    QFETCH(const QStringList, more);
    const QStringList arguments = QStringList{examples + "terrain.sdo", "--seconds", "1.5"} + more;
    const Outcome one = simulate(arguments);
    const Outcome two = simulate(arguments);
    QCOMPARE(one.status, 0);
    QCOMPARE(rowsOf(one.out).size(), 361 * 4);
    QCOMPARE(two.out, one.out);
    QCOMPARE(stateOf(two.err), stateOf(one.err));
    QCOMPARE(one.err.contains("may go through"), more.contains("greedy") || more.contains("--as-dissertation"));
}

void TestSimulate::radiiShrink()
{
    const QList<Row> rows = rowsOf(simulate({path("one.sdo"), "--seconds", "1", "--shrink", "2"}).out);
    QVERIFY(std::abs(rows.last().radius - 0.1 * std::exp(-2.0)) < 1e-15);
}

void TestSimulate::theDissertationsBallsTunnel()
{
    const QStringList arguments{path("fast.sdo"), "--seconds", "0.1"};
    QVERIFY(rowsOf(simulate(arguments).out).last().y > 0);
    QVERIFY(rowsOf(simulate(arguments + QStringList{"--as-dissertation"}).out).last().y < 0);
}

void TestSimulate::recordingsAreReplayed()
{
    const QString file = path("run.txt");
    const QStringList options{"--seconds", "0.7",        "--dt",        "0.004",    "--shrink",
                              "0.3",       "--collider", "approximate", "--record", file};
    const Outcome recorded = simulate(QStringList{examples + "terrain.sdo"} + options);
    QCOMPARE(recorded.status, 0);
    const Outcome replayed = simulate({examples + "terrain.sdo", "--replay", file, "--record", path("again.txt")});
    QCOMPARE(replayed.status, 0);
    QCOMPARE(replayed.out, recorded.out);
    QCOMPARE(bytesOf(path("again.txt")), bytesOf(file));
    QVERIFY(bytesOf(file).endsWith(stateOf(recorded.err) + '\n'));
    // one that says it came to something else
    QByteArray other = bytesOf(file);
    other[other.size() - 2] = other[other.size() - 2] == '0' ? '1' : '0';
    write(path("other.txt"), other);
    const Outcome different = simulate({examples + "terrain.sdo", "--replay", path("other.txt")});
    QCOMPARE(different.status, 3);
    QVERIFY(different.err.contains("another state"));
}

void TestSimulate::recordingsDropBallsAndChangeColliders()
{
    QVERIFY(simulate({path("one.sdo"), "--seconds", "0.5", "--record", path("drop.txt")}).status == 0);
    QByteArray text = bytesOf(path("drop.txt"));
    text.insert(text.indexOf("end "),
                "at 60 drop 1 0.5 0 0 -1 0 0.05 0.25\nat 60 collider simple 0\nat 90 drop 1e-1 .7 0 0 0 0 0.1 1\n");
    write(path("drops.txt"), text);
    const Outcome outcome = simulate({path("one.sdo"), "--replay", path("drops.txt")});
    const QList<Row> rows = rowsOf(outcome.out);
    QCOMPARE(rows.size(), 61 + 2 * 30 + 3 * 30);
    QCOMPARE(rows.last().ball, 2);
    const Row &first = rows[62];
    QVERIFY(first.ball == 1 && first.step == 61 && first.radius == 0.05);
    QVERIFY(std::abs(first.vy + 1 + 9.8 / 240) < 1e-14);
    QVERIFY(outcome.err.contains("another state")); // than before
}

void TestSimulate::recordingsOfOtherScenesAreRefused()
{
    QVERIFY(simulate({path("one.sdo"), "--seconds", "0.1", "--record", path("one.txt")}).status == 0);
    const Outcome outcome = simulate({path("two.sdo"), "--replay", path("one.txt")});
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("not those of the recording"), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
}

void TestSimulate::brokenRecordingsAreStatus1_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("message");
    const QByteArray start = "romanesco recording 1\n";
    QTest::newRow("empty") << QByteArray() << QByteArray("the end is missing");
    QTest::newRow("something else") << QByteArray("v 0 0 0\n") << QByteArray("line 1: this is no recording");
    QTest::newRow("cut off") << start + "gravity 0 0 0\n" << QByteArray("the end is missing");
    const auto bad = [&](const char *name, const QByteArray &line) {
        QTest::newRow(name) << start + "shrink 0\n" + line + "\nend 1 00\n"
                            << QByteArray("line 3: this is not understood");
    };
    bad("an unknown word", "colour red");
    bad("a word alone", "gravity");
    bad("a number that is none", "time-step nan");
    bad("no time", "time-step 0");
    bad("a ball without radius", "at 0 drop 0 0 0 0 0 0 0 1");
    bad("a ball that is too lively", "at 0 drop 0 0 0 0 0 0 1 1.5");
    bad("half a ball", "at 0 drop 0 0 0");
    bad("a ball out of this world", "at 0 drop 1e300 0 0 0 0 0 1 1");
    bad("no such collider", "at 0 collider magic 0");
    bad("no such input", "at 0 dance");
    bad("a step that is none", "at -1 collider bvh 0");
    bad("two ends", "end 1 00");
    bad("no hash", "start xyz");
}

void TestSimulate::brokenRecordingsAreStatus1()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, message);
    write(path("broken.txt"), text);
    const Outcome outcome = simulate({path("one.sdo"), "--replay", path("broken.txt")});
    const bool isSecondEnd = text.contains("end 1 00\nend");
    QVERIFY2(outcome.err.contains(isSecondEnd ? "line 4: this is not understood" : message), outcome.err);
    QCOMPARE(outcome.status, 1);
    QCOMPARE(outcome.out, QByteArray());
}

void TestSimulate::stepsAreClampedWithAWarning()
{
    const Outcome large = simulate({path("one.sdo"), "--seconds", "1", "--dt", "10"});
    QVERIFY2(large.err.contains("warning: --dt 10 is taken for 0.1"), large.err);
    QCOMPARE(rowsOf(large.out).size(), 11);
    const Outcome small = simulate({path("one.sdo"), "--seconds", "1e-5", "--dt", "1e-9"});
    QVERIFY2(small.err.contains("is taken for 1e-06"), small.err);
    QCOMPARE(rowsOf(small.out).size(), 11);
    QCOMPARE(small.status, 0);
}

void TestSimulate::wrongUsageIsStatus2_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *name, const QStringList &arguments, const char *message) {
        QTest::newRow(name) << arguments << QByteArray(message);
    };
    row("no time", {}, "simulate needs --seconds S");
    row("negative time", {"--seconds", "-1"}, "from 0 on, not \"-1\"");
    row("time without end", {"--seconds", "inf"}, "from 0 on, not \"inf\"");
    row("too much time", {"--seconds", "1e300"}, "too many steps");
    row("no step", {"--seconds", "1", "--dt", "0"}, "above 0, not \"0\"");
    row("a step back", {"--seconds", "1", "--dt", "-0.1"}, "above 0, not \"-0.1\"");
    row("a step in words", {"--seconds", "1", "--dt", "short"}, "above 0, not \"short\"");
    row("growing", {"--seconds", "1", "--shrink", "-1"}, "from 0 on, not \"-1\"");
    row("unknown collider", {"--seconds", "1", "--collider", "magic"}, "bvh or simple, not \"magic\"");
    row("tolerance of exact", {"--seconds", "1", "--tolerance", "1"}, "only --collider approximate");
    row("record to stdout", {"--seconds", "1", "--record", "-"}, "--record takes a file");
    row("a replay for a time", {"--replay", "f", "--seconds", "1"}, "--replay takes no --seconds");
    row("a replay with a collider", {"--replay", "f", "--collider", "bvh"}, "--replay takes no --collider");
}

void TestSimulate::wrongUsageIsStatus2()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, message);
    const Outcome outcome = simulate(QStringList{path("one.sdo")} + arguments);
    QVERIFY2(outcome.err.contains(message), outcome.err);
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.out, QByteArray());
}

void TestSimulate::badInputIsStatus1()
{
    QCOMPARE(simulate({path("none.sdo"), "--seconds", "1"}).status, 1);
    QCOMPARE(simulate({path("one.sdo"), "--replay", path("none.txt")}).status, 1);
    const Outcome point = simulate({path("point.sdo"), "--seconds", "1"});
    QCOMPARE(point.status, 3);
    QVERIFY2(point.err.contains("a ball needs a radius above 0"), point.err);
}

void TestSimulate::aFullDeviceIsStatus3()
{
    QProcess process;
    process.setStandardOutputFile(QStringLiteral("/dev/full"));
    process.start(QStringLiteral(ROMANESCO_PROGRAM), {"simulate", path("one.sdo"), "--seconds", "10"});
    process.closeWriteChannel();
    const Outcome outcome = outcomeOf(process);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("cannot write -"), outcome.err);
}

}

ROMANESCO_TEST(romanesco::test::TestSimulate)

#include "testsimulate.moc"
