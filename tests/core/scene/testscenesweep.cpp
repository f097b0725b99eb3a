// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>
#include <glm/geometric.hpp>

#include "core/scene/scenesearch.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/collide/sweeptruth.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Kind = ColliderKind;
using ItemKind = SceneDescription::Kind;

/// With the fractal of an item in its place, its mesh and the way to the copy.
template<typename Use>
void forEachCopy(const Written &written, Use &&use)
{
    for (std::size_t i = 0; i < written.items.size(); ++i) {
        const RandomFractal &sample = written.fractals[written.fractalOfItem[i]];
        naive::Fractal placed = sample.fractal;
        placed.maps.push_back(written.items[i].worldFromModel);
        for (naive::Picks picks : naive::allPicks(placed.levels())) {
            picks.insert(picks.begin(), static_cast<int>(placed.maps.size()) - 1);
            if (written.items[i].kind != ItemKind::Ball) {
                use(placed, sample.mesh, picks);
            }
        }
    }
}

SweepTruth truthOf(const Written &written)
{
    SweepTruth truth;
    forEachCopy(written, [&](const naive::Fractal &placed, const Mesh &mesh, const naive::Picks &picks) {
        truth.add(placed, mesh, picks);
    });
    return truth;
}

std::vector<WideTriangle> facesOf(const Written &written)
{
    std::vector<WideTriangle> faces;
    forEachCopy(written, [&](const naive::Fractal &fractal, const Mesh &mesh, const naive::Picks &picks) {
        for (const Mesh::Face &face : mesh.faces) {
            const auto corner = [&](std::size_t i) { return placed(picks, fractal.maps, mesh.vertices[face[i]]); };
            faces.push_back({corner(0), corner(1), corner(2)});
        }
    });
    return faces;
}

}

class TestSceneSweep : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theFirstTouchOfAllItemsIsFound_data();
    void theFirstTouchOfAllItemsIsFound();
    void whatAMotionComesNearerToIsFound_data();
    void whatAMotionComesNearerToIsFound();
    void itemsBehindOthersAreNotSearched();
    void aBudgetIsForAllItems();
    void itemsFarAwayAreProvedToo();
    void itemsMayBeOfAnySize();
    void scenesOfNothingAreNotTouched();
    void sweepsDoNotAllocateOnceTheyHaveGrown();
};

void TestSceneSweep::theFirstTouchOfAllItemsIsFound_data()
{
    addKinds();
}

void TestSceneSweep::theFirstTouchOfAllItemsIsFound()
{
    QFETCH(const Kind, kind);
    const bool proves = kind != Kind::Greedy && kind != Kind::Octree;
    std::mt19937_64 random(seed(81));
    int touched = 0;
    int missed = 0;
    for (int round = 0; round < 40; ++round) {
        const Written written = randomScene(random);
        const SceneCollider collider = SceneCollider::create(sceneOf(written.items), {kind, 0.01}).value();
        SceneSearch search(collider);
        const SweepTruth truth = truthOf(written);
        for (int i = 0; i < 6 && !truth.triangles().empty(); ++i) {
            const Sweep sweep = randomSweep(random, truth);
            Touch touch;
            search.sweep(sweep, touch);
            const double speed = glm::length(sweep.v);
            const double rounding = 1e-12 * (truth.size() + glm::length(sweep.p) + sweep.radius + speed * sweep.time);
            const double late = speed > 0 ? 1.001e-5 * sweep.radius / speed : 0;
            const double enough = sweep.radius + rounding;
            const auto words = [&] {
                return qPrintable(QStringLiteral("round %1, %2: r %3, %4, at least %5")
                                      .arg(round)
                                      .arg(i)
                                      .arg(sweep.radius)
                                      .arg(touch.time, 0, 'g', 17)
                                      .arg(touch.lower, 0, 'g', 17));
            };
            QVERIFY(touch.promise
                    == (proves                     ? Promise::Exact
                            : kind == Kind::Greedy ? Promise::UpperBound
                                                   : Promise::None));
            ++(touch.isFound() ? touched : missed);
            if (touch.isFound()) {
                const glm::dvec3 centre = sweep.p + touch.time * sweep.v;
                QVERIFY2(touch.time <= sweep.time && glm::distance(touch.point, centre) <= enough, words());
                QVERIFY(std::abs(glm::length(touch.direction) - 1) < 1e-14);
                const Wide toItem = written.distanceToItem(search.item(), touch.point);
                QVERIFY2(kind == Kind::Octree || toItem <= rounding, words());
            }
            if (!proves) {
                QVERIFY(touch.lower == 0.0);
                continue;
            }
            const double until = touch.isFound() ? touch.time - late : sweep.time;
            QVERIFY2(touch.lower >= until - 1e-7 * sweep.time - late, words());
            QVERIFY2(until <= 0 || truth.leastUntil(sweep, until, enough) > sweep.radius - rounding, words());
            const double off = kind == Kind::Exact || kind == Kind::Approximate
                ? 2e-16 * (truth.size() + glm::length(sweep.p) + sweep.radius)
                : rounding;
            QVERIFY2(touch.lower == 0
                         || truth.leastUntil(sweep, touch.lower * (1 - 1e-15), enough) > sweep.radius - off,
                     words());
        }
    }
    QVERIFY2(touched > 50 && missed > 30, qPrintable(QStringLiteral("%1 %2").arg(touched).arg(missed)));
}

void TestSceneSweep::whatAMotionComesNearerToIsFound_data()
{
    QTest::addColumn<Kind>("kind");
    QTest::newRow("exact") << Kind::Exact;
    QTest::newRow("bvh") << Kind::Bvh;
    QTest::newRow("simple") << Kind::Simple;
}

/// Of all faces of items that are turned, mirrored and sheared; what is beside p may count or not.
void TestSceneSweep::whatAMotionComesNearerToIsFound()
{
    QFETCH(const Kind, kind);
    std::mt19937_64 random(seed(86));
    int found = 0;
    for (int round = 0; round < 40; ++round) {
        const Written written = randomScene(random);
        const SceneCollider collider = SceneCollider::create(sceneOf(written.items), {kind, 0.01}).value();
        SceneSearch search(collider);
        const std::vector<WideTriangle> faces = facesOf(written);
        for (int i = 0; i < 4; ++i) {
            const glm::dvec3 p = randomPoint(random, 8);
            const glm::dvec3 motion = randomPoint(random, 1);
            double atLeast = infinity;
            double atMost = infinity;
            for (const WideTriangle &triangle : faces) {
                const truth::Vector<Wide> way = truth::wayFrom<Wide>(triangle, wide(p));
                const auto distance = static_cast<double>(sqrt(truth::dot(way, way)));
                const auto along = static_cast<double>(truth::dot(way, wide(motion)));
                const double beside = 1e-9 * distance * glm::length(motion);
                atLeast = along < beside ? std::min(atLeast, distance) : atLeast;
                atMost = along < -beside ? std::min(atMost, distance) : atMost;
            }
            Hit hit;
            search.closest({.p = p, .motion = motion}, hit);
            const double rounding = 1e-12 * (glm::length(p) + 40);
            QVERIFY2(hit.distance >= atLeast - rounding && hit.distance <= atMost + rounding,
                     qPrintable(QStringLiteral("round %1, %2: %3, but %4 to %5")
                                    .arg(round)
                                    .arg(i)
                                    .arg(hit.distance, 0, 'g', 17)
                                    .arg(atLeast, 0, 'g', 17)
                                    .arg(atMost, 0, 'g', 17)));
            QVERIFY(hit.lower <= atMost + rounding);
            found += hit.isFound() ? 1 : 0;
        }
    }
    QVERIFY2(found > 60, qPrintable(QString::number(found)));
}

void TestSceneSweep::itemsBehindOthersAreNotSearched()
{
    const auto model = modelOf(Mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
    std::vector<SceneItem> items;
    for (int i = 0; i < 1'000; ++i) {
        items.push_back({.model = model, .worldFromModel = {glm::dmat3(1.0), {0, 0, (i * 7) % 1'000}}});
    }
    const SceneCollider collider = SceneCollider::create(sceneOf(items), {Kind::Simple}).value();
    SceneSearch search(collider);
    Touch touch;
    search.sweep({.p = {0.2, 0.2, 499.5}, .v = {0, 0, 2}, .time = 1'000, .radius = 0.25}, touch);
    QVERIFY2(std::abs(touch.time - 0.125) < 1e-11, qPrintable(QString::number(touch.time, 'g', 17)));
    QVERIFY(touch.lower <= touch.time && touch.lower > 0.125 - 1e-5);
    QCOMPARE(search.item() * 7 % 1'000, 500u);
    QCOMPARE(touch.cost.faceTests, 1u);
    search.sweep({.p = {0.2, 0.2, 500.5}, .v = {0, 0, -2}, .time = 0.1, .radius = 0.25}, touch);
    QVERIFY(!touch.isFound() && touch.lower == 0.1 && touch.promise == Promise::Exact);
}

void TestSceneSweep::aBudgetIsForAllItems()
{
    std::mt19937_64 random(seed(82));
    const auto model = modelOf(QStringLiteral("appendix-b"), 5);
    const SceneCollider collider = SceneCollider::create(sceneOf(heapOf(model, random)), {Kind::Exact}).value();
    const auto search = collider.search();
    int spent = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = randomPoint(random, 20);
        const Sweep sweep{.p = p, .v = randomPoint(random, 5) - p, .time = 2, .radius = 0.05};
        Touch truth;
        search->sweep(sweep, truth);
        for (const std::uint64_t budget : {0u, 1u, 3u, 10u, 30u, 1'000'000u}) {
            Sweep less = sweep;
            less.nodeBudget = budget;
            Touch touch;
            search->sweep(less, touch);
            QVERIFY(touch.cost.nodeVisits <= budget);
            QVERIFY(touch.lower <= truth.time && touch.time >= truth.lower);
            if (budget > truth.cost.nodeVisits) {
                QVERIFY(touch.promise == Promise::Exact && touch.time == truth.time);
            } else if (budget + 7 < truth.cost.nodeVisits) {
                QVERIFY(touch.promise == Promise::UpperBound);
                ++spent;
            }
        }
    }
    QVERIFY2(spent > 50, qPrintable(QString::number(spent)));
}

/// Where coordinates are rounded by much more than there is between the sphere and the surface.
void TestSceneSweep::itemsFarAwayAreProvedToo()
{
    std::mt19937_64 random(seed(85));
    int touched = 0;
    for (int round = 0; round < 6; ++round) {
        Written written;
        written.fractals.push_back(randomFractalWithMesh(random, 0.6));
        const RandomFractal &sample = written.fractals.front();
        const AffineMap place = mapFromParts(randomPoint(random, 1e8), randomPoint(random, 180), glm::dvec3(0.7));
        written.items = {{.model = modelOf(sample.graph, sample.mesh), .worldFromModel = place}};
        written.fractalOfItem = {0};
        const SceneCollider collider = SceneCollider::create(sceneOf(written.items), {Kind::Exact}).value();
        const auto search = collider.search();
        const SweepTruth truth = truthOf(written);
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 target = narrow(truth.triangles()[random() % truth.triangles().size()][0]);
            const glm::dvec3 p = target + randomPoint(random, 1);
            const Sweep sweep{.p = p, .v = target - p, .radius = std::pow(10.0, uniform(random, -5, 0))};
            Touch touch;
            search->sweep(sweep, touch);
            touched += touch.isFound() && touch.time > 0.0 ? 1 : 0;
            QVERIFY(touch.lower == 0.0
                    || truth.leastUntil(sweep, touch.lower * (1 - 1e-15), 1.01 * sweep.radius) > sweep.radius);
        }
    }
    QVERIFY2(touched > 30, qPrintable(QString::number(touched)));
}

void TestSceneSweep::itemsMayBeOfAnySize()
{
    std::mt19937_64 random(seed(83));
    const auto model = modelOf(QStringLiteral("menger"), 3);
    const auto alone = SceneCollider::create(sceneOf({{.model = model}}), {Kind::Exact}).value();
    for (const double size : {1e-100, 1e-9, 1e-3, 1e3, 1e9, 1e100}) {
        const AffineMap place = mapFromParts(glm::dvec3(0), {0, 0, 0}, glm::dvec3(size));
        const auto scaled =
            SceneCollider::create(sceneOf({{.model = model, .worldFromModel = place}}), {Kind::Exact}).value();
        for (int i = 0; i < 50; ++i) {
            const Sweep sweep{.p = randomPoint(random, 4), .v = randomPoint(random, 4), .radius = 0.01};
            Sweep there = sweep;
            there.p *= size;
            there.v *= size;
            there.radius *= size;
            Touch one;
            Touch other;
            alone.search()->sweep(sweep, one);
            scaled.search()->sweep(there, other);
            QCOMPARE(one.isFound(), other.isFound());
            QVERIFY(!one.isFound() || std::abs(one.time - other.time) < 1e-6);
            // what grazes goes along a face by the root of how late a time may be: 0.0045 radii
            QVERIFY(!one.isFound() || glm::distance(one.point, other.point / size) < 5e-5);
        }
    }
}

void TestSceneSweep::scenesOfNothingAreNotTouched()
{
    const auto nothing = modelOf(Mesh{});
    const auto ball = modelOf(QStringLiteral("menger"), 1);
    for (const Kind kind : {Kind::Exact, Kind::Bvh, Kind::Greedy}) {
        const auto collider =
            SceneCollider::create(sceneOf({{.model = nothing}, {.model = ball, .kind = ItemKind::Ball}}), {kind})
                .value();
        Touch touch;
        collider.search()->sweep({.p = {-9, 0, 0}, .v = {1, 0, 0}, .time = 99, .radius = 5}, touch);
        QVERIFY(!touch.isFound() && touch.lower == (kind == Kind::Greedy ? 0.0 : 99.0));
    }
}

void TestSceneSweep::sweepsDoNotAllocateOnceTheyHaveGrown()
{
    std::mt19937_64 random(seed(84));
    const auto model = modelOf(QStringLiteral("tree"), 5);
    const AffineMap sheared{glm::dmat3(1, 0, 0, 0.5, 1, 0, 0, 0, 1), {2, 0, 0}};
    const auto collider =
        SceneCollider::create(sceneOf({{.model = model},
                                       {.model = model, .worldFromModel = sheared},
                                       {.model = model, .worldFromModel = {glm::dmat3(2), {0, 5, 0}}}}),
                              {Kind::Exact})
            .value();
    const auto search = collider.search();
    std::vector<Sweep> sweeps;
    for (int i = 0; i < 100; ++i) {
        sweeps.push_back({.p = randomPoint(random, 6), .v = randomPoint(random, 6), .radius = uniform(random, 0, 0.2)});
    }
    Touch touch;
    for (const Sweep &sweep : sweeps) {
        search->sweep(sweep, touch);
    }
    for (const Sweep &sweep : sweeps) { // answers and items exchange their memory
        search->sweep(sweep, touch);
    }
    const std::size_t before = allocationCount();
    for (const Sweep &sweep : sweeps) {
        search->sweep(sweep, touch);
    }
    QCOMPARE(allocationCount(), before);
}

}

ROMANESCO_TEST(romanesco::test::TestSceneSweep)

#include "testscenesweep.moc"
