// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <csignal>

#include <signal.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/cli/program.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

const QString workloads = test::sourcePath("tests/data/collide/");

QJsonObject jsonOf(const Outcome &outcome)
{
    return QJsonDocument::fromJson(outcome.out).object();
}

/// The rows of a collider, by query set.
QMap<QString, QJsonObject> rowsOf(const QJsonObject &measured, const char *collider)
{
    QMap<QString, QJsonObject> rows;
    for (const QJsonValue &row : measured[QLatin1String("colliders")].toArray()) {
        if (row[QLatin1String("collider")] == QLatin1String(collider)) {
            rows[row[QLatin1String("queries")].toString()] = row.toObject();
        }
    }
    return rows;
}

double number(const QJsonObject &row, const char *key)
{
    return row[QLatin1String(key)].toDouble(std::nan(""));
}

/// Without what clocks tell.
QJsonObject withoutTimes(QJsonObject measured)
{
    QJsonArray rows;
    for (const QJsonValue &value : measured[QLatin1String("colliders")].toArray()) {
        QJsonObject row = value.toObject();
        for (const char *key : {"ns_median", "ns_quartiles", "build_ms", "build_ms_quartiles"}) {
            row.remove(QLatin1String(key));
        }
        rows.append(row);
    }
    measured[QLatin1String("colliders")] = rows;
    return measured;
}

}

class TestMeasure : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    QString path(const char *name) const { return m_folder.filePath(QLatin1String(name)); }
    Outcome measure(const QStringList &arguments) const { return run(QStringList{"measure"} + arguments); }
    Outcome measureRotatedTree() const { return measure({workloads + "rotated-tree.fdo", "--depth", "4", "--json"}); }
    /// Measured once for all.
    const Outcome &rotatedTree() const
    {
        static const Outcome outcome = measureRotatedTree();
        return outcome;
    }

private Q_SLOTS:
    void initTestCase();
    void jsonHasItsShape();
    void countsAreTheSameInEveryRun();
    void greedyIsWrongAndExactTakesFewerFaces();
    void greedyIsRightOnSierpinski();
    void tooManyFacesAreToldInWords();
    void tablesAreForPeople();
    void pagesAreXmlAndNeedNothingElse();
    void pagesCanGoToStdout();
    void timeStepsAreMeasuredWhereAskedFor();
    void picturesAreMeasuredWhereAskedFor();
    void withoutADriverThatIsSaid();
    void exportsAreMeasuredWhereAskedFor();
    void theRadiusIsTaken();
    void withoutASurfaceItSaysSo_data();
    void withoutASurfaceItSaysSo();
    void wrongUsageIsStatus2_data();
    void wrongUsageIsStatus2();
    void badInputIsStatus1();
    void whatCannotBeWrittenIsStatus3();
    void cancellingLeavesNothing();
};

void TestMeasure::initTestCase()
{
    QVERIFY(m_folder.isValid());
    write(path("floor.obj"), "v -5 0 -5\nv 5 0 -5\nv -5 0 5\nv 5 0 5\nf 1 2 4 3\n");
    write(path("ball.obj"), "v 0 0 1\nv 0.5 0 0\nv 0 0.5 0\nf 1 2 3\n");
    write(path("one.sdo"), "o \"floor.obj\" #\np \"ball.obj\" ((0, 1, 0), #, (0.1, 0.1, 0.1)) 0.5\n");
    write(path("balls.sdo"), "p \"ball.obj\" ((0, 1, 0), #, (0.1, 0.1, 0.1)) 0.5\n");
    write(path("point.sdo"), "o \"floor.obj\" (#, #, (0, 0, 0))\n");
    write(path("bad.fdo"), "x. \"floor.obj\"\n<$>. gone 3\n");
}

void TestMeasure::jsonHasItsShape()
{
    const Outcome outcome = measure({path("one.sdo"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.err);
    QCOMPARE(outcome.err, QByteArray());
    const QJsonObject measured = jsonOf(outcome);
    const QJsonArray rows = measured[QLatin1String("colliders")].toArray();
    QCOMPARE(rows.size(), 12 * 4); // with what balls ask
    const QStringList keys{"asked",        "build_ms",         "build_ms_quartiles", "bytes",
                           "collider",     "face_tests_mean",  "face_tests_p99",     "missed",
                           "missed_ci",    "node_visits_mean", "ns_median",          "ns_quartiles",
                           "queries",      "reason",           "tolerance",          "touching",
                           "worst",        "wrong_1%",         "wrong_1%_ci",        "wrong_10%",
                           "wrong_10%_ci", "wrong_1e-6",       "wrong_1e-6_ci"};
    for (const QJsonValue &row : rows) {
        QStringList found = row.toObject().keys();
        QStringList expected = keys;
        found.sort();
        expected.sort();
        QCOMPARE(found, expected);
        QVERIFY(row[QLatin1String("reason")].isNull());
        const QJsonArray interval = row[QLatin1String("wrong_1%_ci")].toArray();
        QCOMPARE(interval.size(), 2);
        const double share = row[QLatin1String("wrong_1%")].toDouble();
        QVERIFY(interval[0].toDouble() <= share && share <= interval[1].toDouble() && interval[1].toDouble() <= 1.0);
        QCOMPARE(row[QLatin1String("tolerance")].isNull(),
                 row[QLatin1String("collider")] != QLatin1String("approximate"));
    }
    QCOMPARE(measured[QLatin1String("faces")].toString(), QStringLiteral("2"));
    QVERIFY(std::abs(number(measured, "ball_radius") - 0.1) < 1e-12);
    QCOMPARE(measured[QLatin1String("file")].toString(), path("one.sdo"));
    QVERIFY(!measured.contains(QLatin1String("rendering")));
}

void TestMeasure::countsAreTheSameInEveryRun()
{
    const QJsonObject first = jsonOf(rotatedTree());
    const QJsonObject second = jsonOf(measureRotatedTree());
    QCOMPARE(first[QLatin1String("colliders")].toArray().size(), 12 * 3);
    QCOMPARE(withoutTimes(first), withoutTimes(second));
    QVERIFY(first != second); // of the times some differ
}

/// (TestColliderTrial has others.)
void TestMeasure::greedyIsWrongAndExactTakesFewerFaces()
{
    const Outcome &outcome = rotatedTree();
    QVERIFY2(outcome.status == 0, outcome.err);
    const auto greedy = rowsOf(jsonOf(outcome), "greedy");
    const auto exact = rowsOf(jsonOf(outcome), "exact");
    const auto simple = rowsOf(jsonOf(outcome), "simple");
    QCOMPARE(greedy.size(), 3);
    for (const QString &set : greedy.keys()) {
        QVERIFY(number(greedy[set], "wrong_1e-6") > 0.2);
        QCOMPARE(number(exact[set], "wrong_1e-6"), 0.0);
        QCOMPARE(number(simple[set], "wrong_1e-6"), 0.0);
        QVERIFY(number(exact[set], "face_tests_mean") < 0.3 * number(greedy[set], "face_tests_mean"));
        QVERIFY(number(exact[set], "face_tests_p99") < number(greedy[set], "face_tests_p99"));
    }
    QVERIFY(number(greedy["near"], "missed") > 0.05);
    QCOMPARE(number(exact["near"], "missed"), 0.0);
}

void TestMeasure::greedyIsRightOnSierpinski()
{
    const auto greedy = rowsOf(jsonOf(measure({workloads + "sierpinski.fdo", "--depth", "4", "--json"})), "greedy");
    QCOMPARE(greedy.size(), 3);
    for (const QJsonObject &row : greedy) {
        QCOMPARE(number(row, "asked"), 1600.0);
        QCOMPARE(number(row, "wrong_1e-6"), 0.0);
        QVERIFY(row[QLatin1String("wrong_1e-6_ci")].toArray()[1].toDouble() < 0.0025);
    }
}

void TestMeasure::tooManyFacesAreToldInWords()
{
    const Outcome outcome = measure({examples + "sierpinski.fdo", "--depth", "66", "--json"});
    QVERIFY2(outcome.status == 0, outcome.err);
    for (const char *collider : {"simple", "octree", "bvh"}) {
        const auto rows = rowsOf(jsonOf(outcome), collider);
        QCOMPARE(rows.size(), 3);
        for (const QJsonObject &row : rows) {
            QCOMPARE(row[QLatin1String("reason")].toString(),
                     QStringLiteral("not possible: more than 10^40 faces (at most 5,000,000)"));
            QVERIFY(row[QLatin1String("ns_median")].isNull() && row[QLatin1String("worst")].isNull());
            QVERIFY(row[QLatin1String("missed_ci")].isNull() && row[QLatin1String("bytes")].isNull());
        }
    }
    QCOMPARE(number(rowsOf(jsonOf(outcome), "exact")["near"], "worst"), 0.0);
}

void TestMeasure::tablesAreForPeople()
{
    const Outcome outcome = measure({path("one.sdo")});
    QVERIFY2(outcome.status == 0, outcome.err);
    const QStringList lines = QString::fromUtf8(outcome.out).split(QLatin1Char('\n'));
    QVERIFY(lines.first().endsWith(QStringLiteral("2 faces, a box of diagonal 14.14, a ball of radius 0.1")));
    for (const char *set : {"uniform: 1,600 queries", "near: 1,600 queries", "pocket: 1,600 queries", "balls: "}) {
        QVERIFY2(outcome.out.contains(QByteArray("\n") + set), set);
    }
    // cells stand below their heads
    qsizetype width = 0;
    int rows = 0;
    for (const QString &line : lines) {
        if (line.startsWith(QStringLiteral("  collider")) && line.contains(QStringLiteral("missed"))) {
            width = line.size();
        } else if (line.startsWith(QStringLiteral("  exact")) && width > 0 && rows < 4) {
            QCOMPARE(line.size(), width);
            ++rows;
        }
    }
    QCOMPARE(rows, 4);
}

void TestMeasure::pagesAreXmlAndNeedNothingElse()
{
    write(path("a<b&c.obj"), triangle);
    const Outcome outcome = measure({path("a<b&c.obj"), "--html", path("page.html"), "--json"});
    QVERIFY2(outcome.status == 0, outcome.err);
    QVERIFY(!jsonOf(outcome).isEmpty());
    const QByteArray page = bytesOf(path("page.html"));
    QXmlStreamReader xml(page);
    int pictures = 0;
    int rows = 0;
    while (!xml.atEnd()) {
        if (xml.readNext() == QXmlStreamReader::StartElement) {
            pictures += xml.name() == QLatin1String("svg") ? 1 : 0;
            rows += xml.name() == QLatin1String("tr") ? 1 : 0;
            for (const char *link : {"src", "href", "data", "action"}) {
                QVERIFY(!xml.attributes().hasAttribute(QLatin1String(link)));
            }
            QVERIFY(xml.name() != QLatin1String("script") && xml.name() != QLatin1String("link"));
        }
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    QCOMPARE(pictures, 2 * 3);
    QCOMPARE(rows, 3 * (1 + 12) + 1 + 12);
    QVERIFY(page.startsWith("<!DOCTYPE html>") && page.contains("a&lt;b&amp;c.obj"));
    QVERIFY(!page.contains("url(") && !page.contains("@import"));
}

void TestMeasure::pagesCanGoToStdout()
{
    const Outcome outcome = measure({path("floor.obj"), "--html", "-"});
    QVERIFY2(outcome.status == 0, outcome.err);
    QVERIFY(outcome.out.startsWith("<!DOCTYPE html>") && outcome.out.endsWith("</html>\n"));
}

void TestMeasure::timeStepsAreMeasuredWhereAskedFor()
{
    const Outcome outcome = measure({path("floor.obj"), "--json", "--timestep", "--html", path("steps.html")});
    QVERIFY2(outcome.status == 0, outcome.err);
    const QJsonArray rows = jsonOf(outcome)[QLatin1String("timestep")].toArray();
    QCOMPARE(rows.size(), 12);
    for (const QJsonValue &row : rows) {
        const bool isOurs = row[QLatin1String("integrator")] == QLatin1String("romanesco");
        QCOMPARE(number(row.toObject(), "energy_worst") < 1e-11, isOurs);
        QCOMPARE(row[QLatin1String("missed_ci")].toArray().size(), 2);
        QVERIFY(number(row.toObject(), "us_median") > 0.0 && number(row.toObject(), "dt") <= 1.0 / 30);
    }
    const QByteArray page = bytesOf(path("steps.html"));
    QCOMPARE(page.count("<svg "), 2 * 3 + 2);
    QXmlStreamReader xml(page);
    while (!xml.atEnd()) {
        xml.readNext();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
}

void TestMeasure::picturesAreMeasuredWhereAskedFor()
{
    const Outcome outcome = measure(
        {examples + "sierpinski.fdo", "--depth", "3", "--rendering", "--json", "--html", path("pictures.html")});
    QVERIFY2(outcome.status == 0, outcome.err);
    const QJsonObject rendering = jsonOf(outcome)[QLatin1String("rendering")].toObject();
    QVERIFY(rendering[QLatin1String("device")].toString().startsWith(QStringLiteral("OpenGL 4.5")));
    QCOMPARE(rendering[QLatin1String("references")].toArray().size(), 2);
    const QJsonArray rows = rendering[QLatin1String("rows")].toArray();
    QCOMPARE(rows.size(), 2 * 8);
    for (const QJsonValue &value : rows) {
        const QJsonObject row = value.toObject();
        QCOMPARE(row.size(), 13);
        QVERIFY(row[QLatin1String("reason")].isNull());
        QCOMPARE(number(row, "faces"), 4 * number(row, "copies"));
        QVERIFY(number(row, "ms_median") > 0.0 && number(row, "rms") > 0.0 && number(row, "off") < 1.0);
        QCOMPARE(number(row, "tolerance") == 0.0 && number(row, "rms_alone") > 0.0, false);
    }
    const QJsonArray depths = jsonOf(outcome)[QLatin1String("depths")].toObject()[QLatin1String("rows")].toArray();
    QCOMPARE(depths.last()[QLatin1String("levels")].toInt(), 1000);
    QVERIFY(number(depths.last().toObject(), "px_local_frames") < 2e-3);
    QVERIFY(depths.last()[QLatin1String("px_float")].isNull()); // it is not seen at all

    const QByteArray page = bytesOf(path("pictures.html"));
    QCOMPARE(page.count("<svg "), 2 * 3 + 2 * 2);
    QVERIFY(page.contains("<h2>rendering</h2>") && page.contains("<h2>numbers at depth</h2>"));
    QXmlStreamReader xml(page);
    while (!xml.atEnd()) {
        xml.readNext();
    }
    QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    // where all tolerances make the same picture, which is soon drawn
    const QByteArray table = measure({examples + "sierpinski.fdo", "--depth", "1", "--rendering"}).out;
    for (const char *words : {"\nrendering, view: ", "\nrendering, near: ", "\n  0.25 px ",
                              "\nnumbers at depth: ", "\n  1000 ", " not seen "}) {
        QVERIFY2(table.contains(words), words);
    }
}

/// The rest is measured all the same.
void TestMeasure::withoutADriverThatIsSaid()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("__EGL_VENDOR_LIBRARY_FILENAMES"), QStringLiteral("/nowhere.json"));
    const Outcome outcome = run({"measure", path("floor.obj"), "--rendering", "--json"}, {}, environment);
    QVERIFY2(outcome.status == 0, outcome.err);
    const QJsonObject measured = jsonOf(outcome);
    const QJsonObject rendering = measured[QLatin1String("rendering")].toObject();
    QVERIFY(rendering[QLatin1String("reason")].toString().contains(QStringLiteral("OpenGL 4.5")));
    QVERIFY(rendering[QLatin1String("rows")].toArray().isEmpty());
    QCOMPARE(measured[QLatin1String("depths")][QLatin1String("reason")].toString(),
             QStringLiteral("there is no fractal to go down"));
    QCOMPARE(rowsOf(measured, "exact").size(), 3);
}

/// Bytes are those of the file that `export` writes, but for what it says of itself.
void TestMeasure::exportsAreMeasuredWhereAskedFor()
{
    const QStringList file{examples + "tree.fdo", "--depth", "3"};
    const Outcome outcome = measure(file + QStringList{"--export", "--json", "--html", path("digits.html")});
    QVERIFY2(outcome.status == 0, outcome.err);
    const QJsonObject measured = jsonOf(outcome)[QLatin1String("export")].toObject();
    QVERIFY(measured[QLatin1String("is_whole")].toBool());
    QCOMPARE(measured[QLatin1String("faces_in_all")].toString(), jsonOf(outcome)[QLatin1String("faces")].toString());
    const QJsonArray rows = measured[QLatin1String("rows")].toArray();
    QCOMPARE(rows.size(), 16);
    const auto sizeWithoutComment = [&](const QStringList &options) {
        const Outcome written = run(QStringList{"export"} + file + QStringList{"-o", path("tree.obj")} + options);
        const QByteArray text = bytesOf(path("tree.obj"));
        return written.status == 0 ? text.size() - text.indexOf("\nv ") : qsizetype(0);
    };
    for (const int digits : {3, 6, 17}) {
        const QJsonObject row = rows[digits - 3].toObject();
        QCOMPARE(row[QLatin1String("digits")].toInt(), digits);
        const qsizetype written = sizeWithoutComment({"--digits", QString::number(digits)});
        const qsizetype told = row[QLatin1String("bytes")].toString().toLongLong();
        QVERIFY2(told >= written && told < written + 500, qPrintable(QStringLiteral("%1, %2").arg(told).arg(written)));
        QCOMPARE(number(row, "worst") < 1e-12, digits == 17);
    }
    QVERIFY(rows.last()[QLatin1String("digits")].isNull());
    const QByteArray page = bytesOf(path("digits.html"));
    QCOMPARE(page.count("<svg "), 2 * 3 + 2);
    QVERIFY(page.contains("<h2>export</h2>"));
    const QByteArray table = measure(file + QStringList{"--export"}).out;
    QVERIFY(table.contains("\nexport: all ") && table.contains("\n  3 digits ") && table.contains("\n  shortest "));
}

void TestMeasure::theRadiusIsTaken()
{
    const Outcome outcome = measure({path("floor.obj"), "--json", "--radius", "1000"});
    QCOMPARE(number(jsonOf(outcome), "ball_radius"), 1000.0);
    for (const QJsonObject &row : rowsOf(jsonOf(outcome), "exact")) {
        QCOMPARE(number(row, "touching"), 1600.0);
    }
}

void TestMeasure::withoutASurfaceItSaysSo_data()
{
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("words");
    QTest::newRow("balls alone") << path("balls.sdo") << QByteArray("there is no surface to measure\n");
    QTest::newRow("a point") << path("point.sdo") << QByteArray("the surface is a single point");
}

void TestMeasure::withoutASurfaceItSaysSo()
{
    QFETCH(const QString, file);
    QFETCH(const QByteArray, words);
    const Outcome outcome = measure({file, "--html", path("none.html")});
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains(words), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
    QVERIFY(!QFile::exists(path("none.html")));
}

void TestMeasure::wrongUsageIsStatus2_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char *name, const QStringList &arguments, const char *message) {
        QTest::newRow(name) << arguments << QByteArray(message);
    };
    row("no file", {}, "takes one FILE");
    row("two files", {path("one.sdo"), path("one.sdo")}, "takes one FILE");
    row("unknown option", {path("one.sdo"), "--speed"}, "speed");
    row("no radius", {path("one.sdo"), "--radius", "0"}, "--radius takes a number above 0, not \"0\"");
    row("radius in words", {path("one.sdo"), "--radius", "big"}, "above 0, not \"big\"");
    row("two for stdout", {path("one.sdo"), "--json", "--html", "-"}, "stdout can have either --json or --html");
    row("no page", {path("one.sdo"), "--html", ""}, "--html takes a file");
    row("depth of a mesh", {path("floor.obj"), "--depth", "3"}, "--depth needs");
}

void TestMeasure::wrongUsageIsStatus2()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, message);
    const Outcome outcome = measure(arguments);
    QVERIFY2(outcome.err.contains(message), outcome.err);
    QCOMPARE(outcome.status, 2);
    QCOMPARE(outcome.out, QByteArray());
}

void TestMeasure::badInputIsStatus1()
{
    const Outcome bad = measure({path("bad.fdo")});
    QCOMPARE(bad.status, 1);
    QVERIFY2(bad.err.contains("bad.fdo:2:"), bad.err);
    QCOMPARE(measure({path("gone.fdo")}).status, 1);
}

void TestMeasure::whatCannotBeWrittenIsStatus3()
{
    const Outcome outcome = measure({path("floor.obj"), "--html", "/dev/full"});
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("cannot write /dev/full: "), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
}

void TestMeasure::cancellingLeavesNothing()
{
    write(path("old.html"), "old");
    QProcess process;
    process.start(QStringLiteral(ROMANESCO_PROGRAM),
                  {"measure", examples + "menger.fdo", "--depth", "4", "--html", path("old.html")});
    QVERIFY(process.waitForStarted());
    QTest::qWait(3'000); // by then it hears signals, on a slow machine too
    QCOMPARE(process.state(), QProcess::Running);
    QCOMPARE(::kill(static_cast<pid_t>(process.processId()), SIGINT), 0);
    const Outcome outcome = outcomeOf(process);
    QVERIFY(!outcome.isCrash);
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.err.contains("cancelled"), outcome.err);
    QCOMPARE(outcome.out, QByteArray());
    QCOMPARE(bytesOf(path("old.html")), QByteArray("old"));
}

}

ROMANESCO_TEST(romanesco::test::TestMeasure)

#include "testmeasure.moc"
