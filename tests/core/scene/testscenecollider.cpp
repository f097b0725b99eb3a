// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/scene/scenesearch.h"

#include <QTest>
#include <glm/geometric.hpp>

#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Kind = ColliderKind;
using ItemKind = SceneDescription::Kind;

SceneCollider colliderOf(const std::shared_ptr<const Scene> &scene, Kind kind, double excess = 0.01)
{
    return SceneCollider::create(scene, {kind, excess}).value();
}

const Mesh cube{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
                {{0, 1, 2},
                 {1, 2, 3},
                 {4, 5, 6},
                 {5, 6, 7},
                 {0, 1, 4},
                 {1, 4, 5},
                 {2, 3, 6},
                 {3, 6, 7},
                 {0, 2, 4},
                 {2, 4, 6},
                 {1, 3, 5},
                 {3, 5, 7}}};

AffineMap movedBy(double x, double y, double z)
{
    return {glm::dmat3(1.0), {x, y, z}};
}

}

class TestSceneCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void itFindsTheNearestOfAllItems_data();
    void itFindsTheNearestOfAllItems();
    void itFindsWhatTheModelsColliderFinds_data();
    void itFindsWhatTheModelsColliderFinds();
    void nothingBeyondTheRadiusCounts_data();
    void nothingBeyondTheRadiusCounts();
    void whatWasFoundIsFoundAgainWithin_data();
    void whatWasFoundIsFoundAgainWithin();
    void aBudgetIsForAllItems();
    void itemsBehindOthersAreNotSearched();
    void theItemIsTold();
    void placesOfEverySizeAreSearched();
    void modelsShareTheirColliders();
    void ballsAndNothingHaveNoSurface_data();
    void ballsAndNothingHaveNoSurface();
    void whatIsTooMuchIsRefused_data();
    void whatIsTooMuchIsRefused();
    void stoppingIsHeard_data();
    void stoppingIsHeard();
    void searchesDoNotAllocateOnceTheyHaveGrown();
};

void TestSceneCollider::itFindsTheNearestOfAllItems_data()
{
    addKinds();
}

void TestSceneCollider::itFindsTheNearestOfAllItems()
{
    QFETCH(const Kind, kind);
    const bool proves = kind != Kind::Greedy && kind != Kind::Octree;
    const double excess = kind == Kind::Approximate ? 0.01 : 0.0;
    std::mt19937_64 random(seed(71));
    for (int round = 0; round < 60; ++round) {
        const Written written = randomScene(random);
        const SceneCollider collider = colliderOf(sceneOf(written.items), kind);
        SceneSearch search(collider);
        for (int i = 0; i < 8; ++i) {
            const glm::dvec3 p = randomPoint(random, i % 4 == 0 ? 1000 : 8);
            Hit hit;
            search.closest({p}, hit);
            const auto least = static_cast<double>(written.distance(p));
            const double rounding = 1e-14 * (glm::length(p) + 40);
            const auto words = [&] {
                return qPrintable(QStringLiteral("round %1, %2: %3, but %4, at least %5")
                                      .arg(round)
                                      .arg(i)
                                      .arg(hit.distance, 0, 'g', 17)
                                      .arg(least, 0, 'g', 17)
                                      .arg(hit.lower, 0, 'g', 17));
            };
            QVERIFY2(hit.isFound() == std::isfinite(least), words());
            if (!hit.isFound()) {
                continue;
            }
            if (proves) {
                QVERIFY2(hit.distance >= least * (1 - excess) - rounding
                             && hit.distance <= least * (1 + excess) + rounding,
                         words());
                QVERIFY2(hit.lower <= least * (1 + 1e-15), words());
                QVERIFY2(hit.distance - hit.lower * (1 + 2 * excess) <= 100 * rounding, words());
                QVERIFY(hit.promise == (excess > 0 ? Promise::Within : Promise::Exact) && hit.excess == excess);
            } else {
                QVERIFY2(kind == Kind::Octree || hit.distance >= least - rounding, words());
                QVERIFY(hit.promise == (kind == Kind::Greedy ? Promise::UpperBound : Promise::None) && hit.lower == 0);
            }
            if (kind != Kind::Octree) {
                QVERIFY(written.items.at(search.item()).kind != ItemKind::Ball);
                QVERIFY2(static_cast<double>(written.distanceToItem(search.item(), hit.point))
                             <= excess * hit.distance + rounding,
                         words());
            }
            QVERIFY(std::abs(glm::distance(hit.point, p) - hit.distance) <= rounding);
            QVERIFY(std::abs(glm::length(hit.direction) - 1) < 1e-14);
            if (hit.distance > 1e6 * rounding) {
                QVERIFY(glm::dot(hit.direction, glm::normalize(p - hit.point)) > 1 - 1e-5);
            }
        }
    }
}

void TestSceneCollider::itFindsWhatTheModelsColliderFinds_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("greedy") << Kind::Greedy;
    QTest::newRow("octree") << Kind::Octree;
    QTest::newRow("exact") << Kind::Exact;
}

/// Also what is wrong is the same, only elsewhere and larger.
void TestSceneCollider::itFindsWhatTheModelsColliderFinds()
{
    QFETCH(const Kind, kind);
    std::mt19937_64 random(seed(72));
    const auto model = modelOf(QStringLiteral("tree"), 4);
    std::unique_ptr<Collider> alone;
    if (kind == Kind::Greedy) {
        alone = std::make_unique<GreedyCollider>(GreedyCollider::create(model->graph, *model->mesh).value());
    } else if (kind == Kind::Octree) {
        alone = std::make_unique<OctreeCollider>(OctreeCollider::create(model->graph, *model->mesh).value());
    } else {
        alone =
            std::make_unique<ExactCollider>(ExactCollider::create(model->graph, model->boxes, *model->mesh).value());
    }
    const auto search = alone->search();
    const AffineMap place = mapFromParts({3, -2, 5}, {20, 30, 40}, {-2, 2, 2});
    const SceneCollider collider = colliderOf(sceneOf({{.model = model, .worldFromModel = place}}), kind);
    SceneSearch inScene(collider);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 inModel = randomPoint(random, 3);
        Hit expected;
        search->closest({inModel}, expected);
        Hit hit;
        inScene.closest({place(inModel)}, hit);
        QVERIFY(std::abs(hit.distance - 2 * expected.distance) < 1e-13);
        QVERIFY(glm::distance(hit.point, place(expected.point)) < 1e-12);
        QVERIFY(hit.promise == expected.promise);
        if (kind != Kind::Exact) { // which goes by ties as rounding has them
            QCOMPARE(hit.cost.faceTests, expected.cost.faceTests);
            QCOMPARE(hit.cost.nodeVisits, expected.cost.nodeVisits);
        }
    }
}

void TestSceneCollider::nothingBeyondTheRadiusCounts_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("exact") << Kind::Exact;
    QTest::newRow("approximate") << Kind::Approximate;
    QTest::newRow("bvh") << Kind::Bvh;
    QTest::newRow("simple") << Kind::Simple;
}

void TestSceneCollider::nothingBeyondTheRadiusCounts()
{
    QFETCH(const Kind, kind);
    std::mt19937_64 random(seed(73));
    for (int round = 0; round < 30; ++round) {
        const auto scene = sceneOf(randomScene(random).items);
        const SceneCollider exact = colliderOf(scene, Kind::Exact);
        const SceneCollider collider = colliderOf(scene, kind);
        const auto search = collider.search();
        for (int i = 0; i < 10; ++i) {
            const glm::dvec3 p = randomPoint(random, 10);
            Hit hit;
            exact.search()->closest({p}, hit);
            const double least = hit.distance;
            if (!hit.isFound() || least < 1e-3) {
                continue;
            }
            search->closest({p, least * (1 - 1e-9)}, hit);
            QVERIFY(!hit.isFound() && hit.point == glm::dvec3(0.0));
            QVERIFY(hit.lower > least * (1 - 1e-8) && hit.lower <= least);
            search->closest({p, least * (1 + 1e-9)}, hit);
            QVERIFY(hit.isFound() && std::abs(hit.distance - least) <= 1e-9 * least);
            search->closest({p, least / 3}, hit);
            QVERIFY(!hit.isFound() && std::abs(hit.lower - least / 3) <= 1e-12 * least);
        }
    }
}

void TestSceneCollider::whatWasFoundIsFoundAgainWithin_data()
{
    addKinds();
}

/// To the last digit.
void TestSceneCollider::whatWasFoundIsFoundAgainWithin()
{
    QFETCH(const Kind, kind);
    std::mt19937_64 random(seed(76));
    for (int round = 0; round < 30; ++round) {
        const SceneCollider collider = colliderOf(sceneOf(randomScene(random).items), kind);
        const auto search = collider.search();
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 p = randomPoint(random, i % 4 == 0 ? 1000 : 8);
            Hit hit;
            search->closest({p}, hit);
            if (!hit.isFound()) {
                continue;
            }
            Hit again;
            search->closest({p, hit.distance}, again);
            const double rounding = 1e-12 * (glm::length(p) + 40);
            const bool isAgain = again.distance <= hit.distance
                && (hit.promise != Promise::Exact || again.distance >= hit.distance - rounding);
            QVERIFY2(isAgain,
                     qPrintable(QStringLiteral("round %1, %2: %3, then %4")
                                    .arg(round)
                                    .arg(i)
                                    .arg(hit.distance, 0, 'g', 17)
                                    .arg(again.distance, 0, 'g', 17)));
        }
    }
}

void TestSceneCollider::aBudgetIsForAllItems()
{
    std::mt19937_64 random(seed(74));
    const auto model = modelOf(QStringLiteral("appendix-b"), 5);
    const SceneCollider collider = colliderOf(sceneOf(heapOf(model, random)), Kind::Exact);
    const auto search = collider.search();
    int bounded = 0;
    int spent = 0;
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 p = randomPoint(random, 60);
        Hit truth;
        search->closest({p}, truth);
        for (const std::uint64_t budget : {1u, 5u, 30u, 100u, 1'000u, 1'000'000u}) {
            Hit hit;
            search->closest({.p = p, .nodeBudget = budget}, hit);
            QVERIFY(hit.cost.nodeVisits <= budget);
            QVERIFY(hit.distance >= truth.distance * (1 - 1e-14));
            QVERIFY(hit.lower <= truth.distance * (1 + 1e-15));
            if (budget > truth.cost.nodeVisits) {
                QVERIFY(hit.promise == Promise::Exact && hit.distance == truth.distance);
            } else if (budget + 6 < truth.cost.nodeVisits) {
                QVERIFY(hit.promise != Promise::Exact);
                ++spent;
            }
            if (hit.promise == Promise::Within) {
                QVERIFY(hit.distance <= truth.distance * (1 + hit.excess) * (1 + 1e-14));
                ++bounded;
            }
        }
    }
    QVERIFY2(bounded > 20 && spent > 60, qPrintable(QStringLiteral("%1 %2").arg(bounded).arg(spent)));
}

void TestSceneCollider::itemsBehindOthersAreNotSearched()
{
    const auto model = modelOf(cube);
    std::vector<SceneItem> items;
    for (int i = 0; i < 1'000; ++i) {
        items.push_back({.model = model, .worldFromModel = movedBy(3 * i, 0, 0)});
    }
    const SceneCollider collider = colliderOf(sceneOf(items), Kind::Simple);
    SceneSearch search(collider);
    Hit hit;
    search.closest({{1500.5, 0.5, -1}}, hit);
    QCOMPARE(hit.distance, 1.0);
    QCOMPARE(search.item(), 500u);
    QCOMPARE(hit.cost.faceTests, 12u);
    QVERIFY(hit.lower <= 1.0 && hit.lower > 1.0 - 1e-10);
}

void TestSceneCollider::theItemIsTold()
{
    const auto model = modelOf(cube);
    const SceneCollider collider = colliderOf(sceneOf({{.model = model, .kind = ItemKind::Ball},
                                                       {.model = model, .worldFromModel = movedBy(10, 0, 0)},
                                                       {.model = model, .worldFromModel = movedBy(-10, 0, 0)}}),
                                              Kind::Exact);
    SceneSearch search(collider);
    Hit hit;
    search.closest({{4.8, 0.5, 0.5}}, hit);
    QCOMPARE(search.item(), 1u);
    QVERIFY(glm::distance(hit.point, glm::dvec3(10, 0.5, 0.5)) < 1e-15 && hit.direction == glm::dvec3(-1, 0, 0));
    search.closest({{-4.8, 0.5, 0.5}}, hit);
    QCOMPARE(search.item(), 2u);
    QVERIFY(hit.direction == glm::dvec3(1, 0, 0));
}

void TestSceneCollider::placesOfEverySizeAreSearched()
{
    const auto model = modelOf(QStringLiteral("menger"), 3);
    const double third = 1.0 / 3;
    const double top = 1 + third * (1 + third * (1 + third * 1.5));
    for (const Kind kind : {Kind::Exact, Kind::Bvh, Kind::Simple}) {
        for (const double size : {1e-100, 1e-30, 1e-9, 1e9, 1e30, 1e100}) {
            const AffineMap place = mapFromParts({-1.2 * size, 0, -1.2 * size}, {0, 90, 0}, glm::dvec3(size));
            const SceneCollider collider = colliderOf(sceneOf({{.model = model, .worldFromModel = place}}), kind);
            for (const double away : {2 * size, 1e20, 1e139}) {
                Hit hit;
                collider.search()->closest({{0, away, 0}}, hit);
                const double expected = away - top * size;
                const double rounding = 1e-13 * (away + size);
                QVERIFY2(away < top * size || std::abs(hit.distance - expected) <= rounding,
                         qPrintable(QStringLiteral("%1 %2 %3: %4")
                                        .arg(static_cast<int>(kind))
                                        .arg(size)
                                        .arg(away)
                                        .arg(hit.distance, 0, 'g', 17)));
                QVERIFY(hit.isFound() && hit.lower <= hit.distance);
            }
        }
    }
}

void TestSceneCollider::modelsShareTheirColliders()
{
    std::mt19937_64 random(seed(75));
    const auto model = modelOf(ball(60));
    const auto bytes = [&](int count, Kind kind, const glm::dvec3 &scale) {
        std::vector<SceneItem> items;
        for (int i = 0; i < count; ++i) {
            items.push_back({.model = model, .worldFromModel = mapFromParts(randomPoint(random, 9), {i, 0, 0}, scale)});
        }
        return colliderOf(sceneOf(items), kind).memoryUse();
    };
    for (const Kind kind : {Kind::Exact, Kind::Bvh}) {
        QVERIFY(bytes(100, kind, {2, 2, 2}) < bytes(1, kind, {2, 2, 2}) + 100'000);
    }
    QVERIFY(bytes(100, Kind::Exact, {2, 1, 2}) < bytes(1, Kind::Exact, {2, 1, 2}) + 100'000);
    QVERIFY(bytes(100, Kind::Bvh, {2, 1, 2}) > 90 * bytes(1, Kind::Bvh, {2, 1, 2}));
}

void TestSceneCollider::ballsAndNothingHaveNoSurface_data()
{
    addKinds();
}

void TestSceneCollider::ballsAndNothingHaveNoSurface()
{
    QFETCH(const Kind, kind);
    const auto model = modelOf(cube);
    const std::vector<std::vector<SceneItem>> scenes{{},
                                                     {{.model = model, .kind = ItemKind::Ball}},
                                                     {{.model = modelOf(Mesh{{{1, 2, 3}}, {}})}}};
    for (const auto &items : scenes) {
        const SceneCollider collider = colliderOf(sceneOf(items), kind);
        Hit hit;
        collider.search()->closest({{1, 2, 3}, 7}, hit);
        QVERIFY(!hit.isFound());
        const bool proves = kind != Kind::Greedy && kind != Kind::Octree;
        QCOMPARE(hit.lower, proves ? 7.0 : 0.0);
    }
}

void TestSceneCollider::whatIsTooMuchIsRefused_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<quint64>("depth");
    QTest::addColumn<int>("items");
    QTest::addColumn<bool>("isFlat");
    QTest::addColumn<QString>("words");
    const QString ofMenger = QStringLiteral("m.fdo: 3200000 copies of 12 faces are too many");
    // 20^5 sponges of 12 faces are 38,400,000
    QTest::newRow("bvh") << Kind::Bvh << quint64(6) << 1 << false
                         << "m.fdo: 64000000 copies of 12 faces are too many (at most 100000000 faces)";
    QTest::newRow("simple") << Kind::Simple << quint64(6) << 1 << false
                            << "m.fdo: 64000000 copies of 12 faces are too many (at most 100000000 faces)";
    QTest::newRow("simple, together") << Kind::Simple << quint64(5) << 3 << false << ofMenger;
    QTest::newRow("octree, placed") << Kind::Octree << quint64(5) << 1 << true
                                    << ofMenger + QStringLiteral(" (at most 10000000 faces)");
    QTest::newRow("octree") << Kind::Octree << quint64(5) << 1 << false << "m.fdo: ";
    QTest::newRow("greedy") << Kind::Greedy << quint64(1'000'001) << 1 << false << "m.fdo: a step for each of 1000001";
    QTest::newRow("any depth") << Kind::Bvh << quint64(1'000'000'000'000) << 1 << true << "m.fdo: ~";
}

void TestSceneCollider::whatIsTooMuchIsRefused()
{
    QFETCH(const Kind, kind);
    QFETCH(const quint64, depth);
    QFETCH(const int, items);
    QFETCH(const bool, isFlat);
    QFETCH(const QString, words);
    const AffineMap place = mapFromParts({}, {}, {1, 1, isFlat ? 0 : 1});
    const SceneItem item{.model = modelOf(QStringLiteral("menger"), depth), .worldFromModel = place, .path = "m.fdo"};
    const auto made = SceneCollider::create(sceneOf(std::vector(static_cast<std::size_t>(items), item)), {kind});
    QVERIFY(!made);
    QVERIFY2(made.error().starts_with(words.toStdString()), made.error().c_str());
}

void TestSceneCollider::stoppingIsHeard_data()
{
    addKinds();
}

void TestSceneCollider::stoppingIsHeard()
{
    QFETCH(const Kind, kind);
    std::stop_source stop;
    const auto scene = sceneOf({{.model = modelOf(QStringLiteral("menger"), 3)},
                                {.model = modelOf(cube), .worldFromModel = movedBy(9, 0, 0)}});
    const SceneCollider collider = colliderOf(scene, kind);
    const auto search = collider.search();
    Hit hit;
    search->closest({.p = {5, 5, 5}, .stop = stop.get_token()}, hit);
    QVERIFY(hit.isFound());
    stop.request_stop();
    search->closest({.p = {5, 5, 5}, .stop = stop.get_token()}, hit);
    QVERIFY(!hit.isFound() && hit.promise >= Promise::UpperBound);
    const auto made = SceneCollider::create(scene, {kind}, stop.get_token());
    QVERIFY(!made && made.error().ends_with("cancelled"));
}

void TestSceneCollider::searchesDoNotAllocateOnceTheyHaveGrown()
{
    std::mt19937_64 random(seed(76));
    const auto model = modelOf(QStringLiteral("tree"), 6);
    std::vector<SceneItem> items;
    for (int i = 0; i < 20; ++i) {
        items.push_back({.model = model, .worldFromModel = randomPlace(random)});
    }
    for (const Kind kind : {Kind::Exact, Kind::Approximate, Kind::Bvh}) {
        const SceneCollider collider = colliderOf(sceneOf(items), kind);
        const auto search = collider.search();
        Hit hit;
        std::size_t before = 0;
        for (int round = 0; round < 2; ++round) {
            before = allocationCount();
            std::mt19937_64 same(seed(77));
            for (int i = 0; i < 100; ++i) {
                search->closest({randomPoint(same, 9)}, hit);
            }
        }
        QCOMPARE(allocationCount(), before);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestSceneCollider)

#include "testscenecollider.moc"
