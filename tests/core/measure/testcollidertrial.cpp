// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/measure/collidertrial.h"

#include <algorithm>

#include <QTest>

#include "core/base/file.h"
#include "core/scene/depthchange.h"
#include "core/scene/sceneloader.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/physics/grounds.h"
#include "tests/sourcetree.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Kind = ColliderKind;

/// One of tests/data/collide, at a depth.
std::shared_ptr<const Scene> sceneAt(const std::string &name, const std::string &depth)
{
    const std::filesystem::path path = test::sourcePath("tests/data/collide/").toStdString() + name + ".fdo";
    const DiskFiles disk;
    const DepthChange change(disk, depth);
    return SceneLoader(change).load(path, change.changed(disk.read(path).value())).scene;
}

ColliderTrial tried(const std::shared_ptr<const Scene> &scene, const std::vector<Ball> &balls = {},
                    std::size_t points = 300)
{
    return tryColliders(scene, balls, {.points = points, .mostOperations = 1'000'000}).value();
}

const ColliderRow &rowOf(const ColliderTrial &trial, Kind kind, QuerySet queries)
{
    return *std::ranges::find_if(trial.rows,
                                 [&](const ColliderRow &row) { return row.kind == kind && row.queries == queries; });
}

/// A turned tree, tried once for all.
const ColliderTrial &triedTree()
{
    static const ColliderTrial trial = tried(sceneAt("rotated-tree", "5"));
    return trial;
}

/// The share that is off by more than a millionth.
double wrong(const ColliderTrial &trial, Kind kind, QuerySet queries)
{
    return rowOf(trial, kind, queries).survey.wrong[0].value();
}

}

class TestColliderTrial : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void exactIsNeverWrongAndTakesFewerFaces_data();
    void exactIsNeverWrongAndTakesFewerFaces();
    void greedyIsRightOnSierpinski();
    void toleranceIsKept();
    void countsAreTheSameInEveryRun();
    void rowsAreBySetAndKind();
    void ballsAreMeasured();
    void theBallIsTheLeastOfTheScene();
    void tooManyFacesAreTold();
    void whatIsSlowIsAskedLess();
    void whatIsTooSlowIsNotTried();
    void whatCannotBeBuiltIsTold();
    void timesAreTold();
    void stoppingIsHeard_data();
    void stoppingIsHeard();
};

void TestColliderTrial::exactIsNeverWrongAndTakesFewerFaces_data()
{
    QTest::addColumn<ColliderTrial>("trial");
    QTest::newRow("appendix B") << tried(sceneAt("appendix-b", "2"));
    QTest::newRow("rotated tree") << triedTree();
}

/// Written out by two other colliders, which share neither bounds nor frames with it.
void TestColliderTrial::exactIsNeverWrongAndTakesFewerFaces()
{
    QFETCH(const ColliderTrial, trial);
    QCOMPARE(trial.sets.size(), 3u);
    for (const QuerySet set : {QuerySet::Uniform, QuerySet::Near, QuerySet::Pocket}) {
        for (const Kind kind : {Kind::Exact, Kind::Bvh, Kind::Simple}) {
            const ColliderRow &row = rowOf(trial, kind, set);
            QVERIFY2(row.reason.empty(), row.reason.c_str());
            QCOMPARE(row.survey.wrong[0].count, 0u);
            QCOMPARE(row.survey.missed.count, 0u);
        }
        QVERIFY(wrong(trial, Kind::Octree, set) > 0.7);
        const Survey &greedy = rowOf(trial, Kind::Greedy, set).survey;
        const Survey &exact = rowOf(trial, Kind::Exact, set).survey;
        QVERIFY2(greedy.wrong[0].value() > 0.3, qPrintable(QString::number(greedy.wrong[0].value())));
        QVERIFY(exact.faceTestsMean < 0.3 * greedy.faceTestsMean);
        QVERIFY(exact.faceTestsP99 < greedy.faceTestsP99);
        QCOMPARE(exact.asked, 300u);
        QVERIFY(rowOf(trial, Kind::Simple, set).survey.asked >= 50);
    }
}

void TestColliderTrial::greedyIsRightOnSierpinski()
{
    const ColliderTrial trial = tried(sceneAt("sierpinski", "5"));
    for (const ColliderTrial::Set &set : trial.sets) {
        QCOMPARE(wrong(trial, Kind::Greedy, set.queries), 0.0);
        QVERIFY(wrong(trial, Kind::Octree, set.queries) > 0.7);
    }
}

void TestColliderTrial::toleranceIsKept()
{
    const ColliderTrial &trial = triedTree();
    const auto tolerances = trialTolerances();
    QCOMPARE(tolerances.front(), 1e-6);
    QCOMPARE(tolerances.back(), 0.5);
    std::size_t rows = 0;
    double largest = 0.0;
    for (const ColliderRow &row : trial.rows) {
        if (row.kind == Kind::Approximate) {
            QVERIFY(row.survey.worst <= row.tolerance.value() * (1 + 1e-6));
            largest = std::max(largest, row.survey.worst);
            ++rows;
        } else {
            QVERIFY(!row.tolerance);
        }
    }
    QCOMPARE(rows, 3 * tolerances.size());
    QVERIFY(largest > 0.2); // it makes use of it
}

void TestColliderTrial::countsAreTheSameInEveryRun()
{
    const auto scene = sceneAt("rotated-tree", "3");
    const std::vector<Ball> balls{{.position = {0.1, 3, 0.1}, .radius = 0.05, .restitution = 0.6}};
    const ColliderTrial first = tried(scene, balls, 100);
    const ColliderTrial second = tried(scene, balls, 100);
    QCOMPARE(first.rows.size(), second.rows.size());
    for (std::size_t i = 0; i < first.rows.size(); ++i) {
        const Survey &a = first.rows[i].survey;
        const Survey &b = second.rows[i].survey;
        QCOMPARE(a.asked, b.asked);
        QCOMPARE(a.faceTestsMean, b.faceTestsMean);
        QCOMPARE(a.faceTestsP99, b.faceTestsP99);
        QCOMPARE(a.nodeVisitsMean, b.nodeVisitsMean);
        QCOMPARE(a.worst, b.worst);
        QCOMPARE(a.wrong[0].count, b.wrong[0].count);
        QCOMPARE(a.missed.count, b.missed.count);
        QCOMPARE(first.rows[i].bytes, second.rows[i].bytes);
    }
}

void TestColliderTrial::rowsAreBySetAndKind()
{
    const ColliderTrial trial = tried(sceneOf({{.model = modelOf(ball(20))}}), {}, 50);
    std::vector<std::string> names;
    for (const ColliderRow &row : trial.rows) {
        if (row.queries == QuerySet::Near) {
            names.push_back(nameOf(row));
        }
    }
    const std::vector<std::string> expected{"exact",
                                            "approximate 1e-6",
                                            "approximate 1e-5",
                                            "approximate 1e-4",
                                            "approximate 0.001",
                                            "approximate 0.01",
                                            "approximate 0.1",
                                            "approximate 0.5",
                                            "greedy",
                                            "octree",
                                            "bvh",
                                            "simple"};
    QCOMPARE(names, expected);
    QVERIFY(std::ranges::is_sorted(trial.rows, {}, &ColliderRow::queries));
    QCOMPARE(trial.faces->toInteger().value(), 760u);
}

void TestColliderTrial::ballsAreMeasured()
{
    const auto model = modelOf(QStringLiteral("tree"), 5);
    const auto scene = sceneOf({{.model = model}, {.model = modelOf(floorMesh(4))}});
    std::vector<Ball> balls;
    for (int i = 0; i < 12; ++i) {
        balls.push_back(
            {.position = {0.2 * i - 1.2, 3.0 + 0.3 * i, 0.07 * i - 0.4}, .radius = 0.04, .restitution = 0.7});
    }
    const ColliderTrial trial = tried(scene, balls, 1'600);
    QCOMPARE(trial.sets.size(), 4u);
    QVERIFY(trial.sets.back().queries == QuerySet::Balls);
    QVERIFY(trial.sets.back().touching > 50);
    for (const Kind kind : {Kind::Exact, Kind::Bvh, Kind::Simple}) {
        const ColliderRow &row = rowOf(trial, kind, QuerySet::Balls);
        QVERIFY(row.survey.asked > 100);
        QCOMPARE(row.survey.wrong[0].count, 0u);
        QCOMPARE(row.survey.missed.count, 0u);
    }
    const double wrongOctree = wrong(trial, Kind::Octree, QuerySet::Balls);
    QVERIFY2(wrongOctree > 0.02, qPrintable(QString::number(wrongOctree)));
}

void TestColliderTrial::theBallIsTheLeastOfTheScene()
{
    const auto scene = sceneOf({{.model = modelOf(floorMesh(4))}});
    QVERIFY(std::abs(tried(scene, {}, 10).ballRadius - 0.02 * std::sqrt(128.0)) < 1e-3);
    const std::vector<Ball> balls{{.position = {0, 3, 0}, .radius = 0.5}, {.position = {2, 3, 0}, .radius = 0.25}};
    QCOMPARE(tried(scene, balls, 10).ballRadius, 0.25);
    QCOMPARE(tryColliders(scene, balls, {.points = 10, .ballRadius = 3.0})->ballRadius, 3.0);
}

void TestColliderTrial::tooManyFacesAreTold()
{
    const auto scene = sceneAt("menger", "30");
    const ColliderTrial trial = tried(scene, {}, 50);
    for (const Kind kind : {Kind::Octree, Kind::Bvh, Kind::Simple}) {
        QCOMPARE(QString::fromStdString(rowOf(trial, kind, QuerySet::Near).reason),
                 QStringLiteral("not possible: more than 10^40 faces (at most 5,000,000)"));
    }
    for (const Kind kind : {Kind::Exact, Kind::Approximate, Kind::Greedy}) {
        QVERIFY(rowOf(trial, kind, QuerySet::Near).reason.empty());
    }
    const auto few = tryColliders(sceneAt("menger", "2"), {}, {.points = 5, .mostFaces = 4'799});
    QCOMPARE(QString::fromStdString(rowOf(*few, Kind::Simple, QuerySet::Near).reason),
             QStringLiteral("not possible: 4,800 faces (at most 4,799)"));
    const auto enough = tryColliders(sceneAt("menger", "2"), {}, {.points = 5, .mostFaces = 4'800});
    QVERIFY(rowOf(*enough, Kind::Simple, QuerySet::Near).reason.empty());
}

void TestColliderTrial::whatIsSlowIsAskedLess()
{
    const ColliderTrial trial = tried(sceneAt("menger", "3"), {}, 50);
    // 96,000 faces for each
    QCOMPARE(rowOf(trial, Kind::Simple, QuerySet::Uniform).survey.asked, 11u);
    QCOMPARE(rowOf(trial, Kind::Bvh, QuerySet::Uniform).survey.asked, 50u);
}

/// 960 transformations of 12 faces in each of a hundred thousand steps.
void TestColliderTrial::whatIsTooSlowIsNotTried()
{
    const ColliderTrial trial = tried(sceneAt("menger", "200000"), {}, 5);
    const ColliderRow &first = rowOf(trial, Kind::Greedy, QuerySet::Uniform);
    QVERIFY2(first.reason.starts_with("not tried: a query takes 4.8e+07 face tests"), first.reason.c_str());
    QCOMPARE(rowOf(trial, Kind::Greedy, QuerySet::Pocket).reason, first.reason);
    QVERIFY(rowOf(trial, Kind::Exact, QuerySet::Pocket).reason.empty());
}

void TestColliderTrial::whatCannotBeBuiltIsTold()
{
    const ColliderTrial trial = tried(sceneAt("menger", "2000000"), {}, 5);
    const ColliderRow &row = rowOf(trial, Kind::Greedy, QuerySet::Uniform);
    QVERIFY2(row.reason.starts_with("not possible: ") && row.reason.contains("1000000"), row.reason.c_str());
}

void TestColliderTrial::timesAreTold()
{
    const ColliderTrial &trial = triedTree();
    for (const ColliderRow &row : trial.rows) {
        QVERIFY(row.nanoseconds.lowerQuartile > 0.0);
        QVERIFY(row.nanoseconds.lowerQuartile <= row.nanoseconds.median);
        QVERIFY(row.nanoseconds.median <= row.nanoseconds.upperQuartile);
        QVERIFY(row.buildMilliseconds.median > 0.0 && row.bytes > 0);
    }
    // a face takes more than a nanosecond, and no second
    const ColliderRow &simple = rowOf(trial, Kind::Simple, QuerySet::Uniform);
    QVERIFY(simple.nanoseconds.median > simple.survey.faceTestsMean);
}

void TestColliderTrial::stoppingIsHeard_data()
{
    QTest::addColumn<int>("at");
    for (const int at : {1, 2, 5, 9}) {
        QTest::addRow("%d", at) << at;
    }
}

void TestColliderTrial::stoppingIsHeard()
{
    QFETCH(const int, at);
    std::stop_source stop;
    int told = 0;
    double latest = 0.0;
    bool isAscending = true;
    const TrialContext context{stop.get_token(), [&](const std::string &, double share) {
                                   isAscending = isAscending && share >= latest && share <= 1.0;
                                   latest = share;
                                   if (++told == at) {
                                       stop.request_stop();
                                   }
                               }};
    const auto made = tryColliders(sceneAt("rotated-tree", "2"), {}, {.points = 50}, context);
    QVERIFY(!made.has_value());
    QCOMPARE(made.error(), std::string("cancelled"));
    QCOMPARE(told, at);
    QVERIFY(isAscending);
}

}

ROMANESCO_TEST(romanesco::test::TestColliderTrial)

#include "testcollidertrial.moc"
