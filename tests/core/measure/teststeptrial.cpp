// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/steptrial.h"

#include <algorithm>

#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double gravity = 9.8;

StepTrial tried(const std::shared_ptr<const Scene> &scene, std::size_t balls = 40, double radius = 0.1)
{
    return tryTimeSteps(scene, {}, {.balls = balls, .ballRadius = radius}).value();
}

}

class TestStepTrial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void oursKeepsEnergyAndLandsWhereItShould_data();
    void oursKeepsEnergyAndLandsWhereItShould();
    void theDissertationsErrorsAreThoseOfItsFormula();
    void thinThingsAreMissed();
    void countsAreTheSameInEveryRun();
    void whatNothingLandsOnIsRefused();
    void stoppingIsHeard();
};

void TestStepTrial::oursKeepsEnergyAndLandsWhereItShould_data()
{
    QTest::addColumn<std::shared_ptr<const Scene>>("scene");
    QTest::newRow("floor") << sceneOf({{.model = modelOf(floorMesh(4))}});
    QTest::newRow("box") << sceneOf(
        {{.model = modelOf(boxMesh(1)), .worldFromModel = mapFromParts({1, 2, 3}, {20, 30, 40}, {1, 1, 1})}});
    QTest::newRow("tree") << sceneOf({{.model = modelOf(QStringLiteral("tree"), 6)}});
}

/// The reference asks for distances alone, ours sweeps: 1e-4 of the radius is what it touches within, and on a slope it may
/// be farther off along that.
void TestStepTrial::oursKeepsEnergyAndLandsWhereItShould()
{
    QFETCH(const std::shared_ptr<const Scene>, scene);
    const StepTrial trial = tried(scene);
    QCOMPARE(trial.rows.size(), 12u);
    for (std::size_t i = 0; i < 6; ++i) {
        const StepRow &row = trial.rows[i];
        QVERIFY(!row.isAsInDissertation && row.balls == 40 && row.missed.of == 40);
        QCOMPARE(row.missed.count, 0u);
        QVERIFY2(row.energyWorst < 1e-11, qPrintable(QString::number(row.energyWorst)));
        QVERIFY2(row.landingMedian <= 3e-4 && row.landingWorst < 0.05, qPrintable(QString::number(row.landingWorst)));
        QVERIFY(row.landingMedian > 1e-6); // the skin
    }
}

/// On a floor, by hand: a ball falls in steps, until its centre is less than the radius above it; there it is put on the
/// floor, where it would have landed, and its velocity turned round.
void TestStepTrial::theDissertationsErrorsAreThoseOfItsFormula()
{
    const StepTrial trial = tried(sceneOf({{.model = modelOf(floorMesh(4))}}), 60, 0.5);
    for (std::size_t i = 6; i < 12; ++i) {
        const StepRow &row = trial.rows[i];
        QVERIFY(row.isAsInDissertation);
        QVERIFY(row.landingWorst < 1e-6); // it is pushed straight up, to the place itself
        // it is pushed out by up to a step's way, and loses or gains what that is worth: v·dt of the height
        const double fastest = std::sqrt(2 * gravity * trial.height);
        const double most = 4.0 * fastest * row.timeStep / (0.5 * trial.height);
        QVERIFY2(row.energyWorst > most / 100 && row.energyWorst < most, qPrintable(QString::number(row.energyWorst)));
        // a query for each step
        QVERIFY(std::abs(row.queries * row.timeStep - 1.0) < 0.03);
    }
    // twice as many steps, about half the error
    QVERIFY(trial.rows[11].energyMedian < 0.2 * trial.rows[6].energyMedian);
}

/// A ball of a centimetre goes 30 in a step of 1/30 s after a second.
void TestStepTrial::thinThingsAreMissed()
{
    const StepTrial trial = tried(sceneOf({{.model = modelOf(floorMesh(20))}}), 60, 0.01);
    QVERIFY(trial.rows[6].missed.value() > 0.7);
    QCOMPARE(trial.rows[6].missed.of, 60u);
    QVERIFY(trial.rows[0].missed.count == 0);
    QVERIFY(trial.rows[11].missed.count < trial.rows[6].missed.count);
}

void TestStepTrial::countsAreTheSameInEveryRun()
{
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("tree"), 4)}});
    const StepTrial first = tried(scene, 10);
    const StepTrial second = tried(scene, 10);
    for (std::size_t i = 0; i < 12; ++i) {
        QCOMPARE(first.rows[i].faceTests, second.rows[i].faceTests);
        QCOMPARE(first.rows[i].energyWorst, second.rows[i].energyWorst);
        QCOMPARE(first.rows[i].landingMedian, second.rows[i].landingMedian);
        QVERIFY(first.rows[i].microseconds.median > 0.0);
    }
    QCOMPARE(nameOf(first.rows[3]), std::string("romanesco 1/240"));
    QCOMPARE(nameOf(first.rows[6]), std::string("dissertation 1/30"));
    // what takes more is asked less
    const auto few = tryTimeSteps(scene, {}, {.balls = 10, .mostOperations = 1});
    QCOMPARE(few->rows[0].balls, 1u);
}

/// A vertical wall without thickness: a ball that comes down on its edge grazes, and beside it passes.
void TestStepTrial::whatNothingLandsOnIsRefused()
{
    const auto refused = [](std::vector<SceneItem> items) {
        return QString::fromStdString(tryTimeSteps(sceneOf(std::move(items)), {}, {.balls = 5}).error());
    };
    QCOMPARE(refused({}), QStringLiteral("there is no surface to measure"));
    // far apart, so that none of a few balls comes near
    const Mesh needle{{{0, 0, 0}, {0, 1e-9, 0}, {1e-9, 0, 0}}, {{0, 1, 2}}};
    const auto tiny =
        tryTimeSteps(sceneOf({{.model = modelOf(needle)},
                              {.model = modelOf(needle), .worldFromModel = {glm::dmat3(1), {1e6, 0, 1e6}}}}),
                     {}, {.balls = 5, .ballRadius = 1e-3});
    QCOMPARE(QString::fromStdString(tiny.error()),
             QStringLiteral("no ball that comes down from above lands on the surface"));
}

void TestStepTrial::stoppingIsHeard()
{
    std::stop_source stop;
    int told = 0;
    const TrialContext context{stop.get_token(), [&](const std::string &, double) {
                                   if (++told == 3) {
                                       stop.request_stop();
                                   }
                               }};
    const auto made = tryTimeSteps(sceneOf({{.model = modelOf(floorMesh(4))}}), {}, {}, context);
    QVERIFY(!made.has_value());
    QCOMPARE(made.error(), std::string("cancelled"));
    QCOMPARE(told, 3);
}

}

ROMANESCO_TEST(romanesco::test::TestStepTrial)

#include "teststeptrial.moc"
