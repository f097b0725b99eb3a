// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/depthtrial.h"

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <QTest>

#include "core/measure/deepfractal.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

DepthTrial tried(const char *example, std::uint64_t depth)
{
    return tryDepths(*sceneOf({{.model = modelOf(QLatin1String(example), depth)}})).value();
}

/// Of three levels, each example once.
const DepthTrial &triedShallow(const char *example)
{
    static std::map<std::string, DepthTrial> trials;
    const auto found = trials.find(example);
    return found != trials.end() ? found->second : trials.emplace(example, tried(example, 3)).first->second;
}

/// What the last digit of the camera's place is worth on the screen, in pixels: it is about 1 from the origin, and twice
/// the size of what it looks at away from that.
double digitOnScreen(double epsilon, const DepthRow &row)
{
    const double pixels = 0.5 * DepthTrial::height * std::numbers::sqrt3;
    return 0.5 * epsilon * pixels / (2.0 * std::pow(10.0, row.sizeLog10));
}

}

class TestDepthTrial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void localFramesHoldAtEveryDepth_data();
    void localFramesHoldAtEveryDepth();
    void worldCoordinatesEndWhereTheirDigitsDo_data();
    void worldCoordinatesEndWhereTheirDigitsDo();
    void whereLevelsEndTheWholeFollows();
    void withoutAFractalItSaysSo();
    void whatNeedNotShrinkEndsWithItsLevels();
    void stoppingIsHeard();
};

void TestDepthTrial::localFramesHoldAtEveryDepth_data()
{
    QTest::addColumn<QString>("example");
    for (const char *name : {"menger", "sierpinski", "tree", "two-sets", "romanesco"}) {
        QTest::newRow(name) << QString::fromLatin1(name);
    }
}

/// Off by what a card's floats cannot tell, a thousandth of a pixel, at any depth.
void TestDepthTrial::localFramesHoldAtEveryDepth()
{
    QFETCH(const QString, example);
    const DepthTrial &trial = triedShallow(qPrintable(example));
    QCOMPARE(trial.reason, std::string());
    QCOMPARE(trial.rows.size(), trialDepths().size());
    for (const DepthRow &row : trial.rows) {
        QCOMPARE(row.reason, std::string());
        QVERIFY(row.copies >= 1);
        QVERIFY2(row.inFrames > 0.0 && row.inFrames < 2e-3,
                 qPrintable(QStringLiteral("%1 at %2").arg(row.inFrames).arg(row.depth)));
        QVERIFY2(row.depth < 200 || (row.inFloat > 10.0 && row.inDouble > 10.0),
                 qPrintable(QStringLiteral("%1, %2 at %3").arg(row.inFloat).arg(row.inDouble).arg(row.depth)));
    }
    QVERIFY(trial.rows.back().sizeLog10 < -100.0);
}

void TestDepthTrial::worldCoordinatesEndWhereTheirDigitsDo_data()
{
    localFramesHoldAtEveryDepth_data();
}

/// Some times the last digit of the camera's place, while that is between a hundredth of a pixel and a picture.
void TestDepthTrial::worldCoordinatesEndWhereTheirDigitsDo()
{
    QFETCH(const QString, example);
    const DepthTrial &trial = triedShallow(qPrintable(example));
    int looked = 0;
    for (const DepthRow &row : trial.rows) {
        const std::pair<double, double> kinds[]{{row.inFloat, 0x1p-23}, {row.inDouble, 0x1p-52}};
        for (const auto &[off, epsilon] : kinds) {
            const double digit = digitOnScreen(epsilon, row);
            if (digit > 0.01 && digit < 100.0) {
                QVERIFY2(off > 0.05 * digit && off < 50.0 * digit,
                         qPrintable(QStringLiteral("%1, a digit is %2").arg(off).arg(digit)));
                ++looked;
            }
        }
    }
    QVERIFY(looked >= 1);
}

void TestDepthTrial::whereLevelsEndTheWholeFollows()
{
    const DepthTrial &shallow = triedShallow("menger");
    const DepthTrial deep = tried("menger", 3 * 1001);
    for (std::size_t i = 0; i < deep.rows.size(); ++i) {
        QCOMPARE(shallow.rows[i].copies, deep.rows[i].copies);
        QCOMPARE(shallow.rows[i].inFloat, deep.rows[i].inFloat);
        QCOMPARE(shallow.rows[i].inDouble, deep.rows[i].inDouble);
        QCOMPARE(shallow.rows[i].inFrames, deep.rows[i].inFrames);
        const double size = -std::log10(3.0) * (double(deep.rows[i].depth) - 1.0);
        QVERIFY(std::abs(shallow.rows[i].sizeLog10 - size) < 1e-9 * (1.0 - size));
    }
}

void TestDepthTrial::withoutAFractalItSaysSo()
{
    const DepthTrial trial = tryDepths(*sceneOf({{.model = modelOf(boxMesh(1))}})).value();
    QCOMPARE(trial.reason, std::string("there is no fractal to go down"));
    QVERIFY(trial.rows.empty());
}

/// All levels of the snowflake but its turns may be passed over, and what is only turned stays as large.
void TestDepthTrial::whatNeedNotShrinkEndsWithItsLevels()
{
    const DepthTrial trial = tried("snowflake", 4);
    QCOMPARE(trial.rows.front().reason, std::string());
    QVERIFY(trial.rows.front().copies > 0);
    QCOMPARE(trial.rows.back().reason, std::string("not possible: the way ends before"));
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("snowflake"), 4)}});
    QCOMPARE(deepFractal(*scene, 1001).value()->items[0].model->graph.levels().levelCount(), Position(7));
    const auto menger = sceneOf({{.model = modelOf(QStringLiteral("menger"), 4)}});
    QCOMPARE(deepFractal(*menger, 1001).value()->items[0].model->graph.levels().levelCount(), Position(4 * 1001));
}

void TestDepthTrial::stoppingIsHeard()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 3)}});
    std::stop_source stop;
    int told = 0;
    const auto trial = tryDepths(*scene, {stop.get_token(), [&](const std::string &, double) {
                                              ++told;
                                              stop.request_stop();
                                          }});
    QVERIFY(!trial && trial.error() == "cancelled");
    QCOMPARE(told, 1);
}

}

ROMANESCO_TEST(romanesco::test::TestDepthTrial)

#include "testdepthtrial.moc"
