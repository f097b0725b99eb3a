// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/trialplots.h"

#include <QTest>

#include "tests/testmain.h"

namespace romanesco::test {

namespace {

ColliderRow rowOf(ColliderKind kind, QuerySet set, double nanoseconds, double faces, double worst)
{
    ColliderRow row{.kind = kind, .queries = set};
    row.nanoseconds = {nanoseconds, 0.9 * nanoseconds, 1.1 * nanoseconds};
    row.survey.faceTestsMean = faces;
    row.survey.worst = worst;
    return row;
}

}

/// Error against cost, of what was tried.
class TestTrialPlots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void eachRowOfASetHasAPoint();
    void whatCannotBeDrawnHasNone();
    void stepsArePlottedTwice();
};

void TestTrialPlots::eachRowOfASetHasAPoint()
{
    ColliderTrial trial;
    trial.rows = {rowOf(ColliderKind::Exact, QuerySet::Uniform, 100, 5, 0.0),
                  rowOf(ColliderKind::Exact, QuerySet::Near, 200, 6, 0.0),
                  rowOf(ColliderKind::Greedy, QuerySet::Near, 300, 7, 0.5)};
    const std::vector<TrialPlot> plots = plotsOf(trial, QuerySet::Near);
    QCOMPARE(plots.size(), 2U);
    for (const TrialPlot &plot : plots) {
        QCOMPARE(plot.rows, (std::vector<std::size_t>{1, 2}));
        QCOMPARE(plot.points[0].label, std::string("exact"));
        QCOMPARE(plot.points[0].error, 0.0);
        QCOMPARE(plot.points[1].error, 0.5);
        QVERIFY(plot.points[0].group != plot.points[1].group);
    }
    QCOMPARE(plots[0].points[1].cost, 300.0);
    QCOMPARE(plots[0].points[1].spread->upperQuartile, 330.0);
    QCOMPARE(plots[1].points[1].cost, 7.0);
    QVERIFY(!plots[1].points[1].spread);
    QVERIFY(plots[0].title != plots[1].title);
}

/// On an axis by logarithms.
void TestTrialPlots::whatCannotBeDrawnHasNone()
{
    ColliderTrial trial;
    trial.rows = {rowOf(ColliderKind::Exact, QuerySet::Near, 200, 0, 0.0),
                  rowOf(ColliderKind::Bvh, QuerySet::Near, 200, 6, 0.0)};
    trial.rows[1].reason = "not possible";
    const std::vector<TrialPlot> plots = plotsOf(trial, QuerySet::Near);
    QCOMPARE(plots[0].rows, (std::vector<std::size_t>{0}));
    QVERIFY(plots[1].points.empty() && plots[1].rows.empty());
    QVERIFY(plotsOf(trial, QuerySet::Balls)[0].points.empty());
}

void TestTrialPlots::stepsArePlottedTwice()
{
    StepTrial trial;
    trial.rows = {{.timeStep = 1.0 / 30.0, .microseconds = {5, 4, 6}, .energyWorst = 0.1, .landingWorst = 0.2},
                  {.isAsInDissertation = true, .timeStep = 1.0 / 60.0, .energyWorst = 1.0},
                  {.isAsInDissertation = true, .timeStep = 1.0 / 60.0, .microseconds = {7, 6, 8}, .energyWorst = 0.3}};
    const std::vector<TrialPlot> plots = plotsOf(trial);
    QCOMPARE(plots.size(), 2U);
    QCOMPARE(plots[0].rows, (std::vector<std::size_t>{0, 2}));
    QCOMPARE(plots[0].points[0].error, 0.1);
    QCOMPARE(plots[1].points[0].error, 0.2);
    QCOMPARE(plots[0].points[1].cost, 7.0);
    QVERIFY(plots[0].points[0].group != plots[0].points[1].group);
}

}

ROMANESCO_TEST(romanesco::test::TestTrialPlots)

#include "testtrialplots.moc"
