// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/equalproducts.h"

#include <set>

#include <QTest>

#include "core/collide/exactcollider.h"
#include "core/collide/simplecollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

struct Built {
    FractalGraph graph;
    BoxBounds boxes;
};

/// So many levels of one set.
naive::Fractal repeated(std::vector<AffineMap> maps, int levels, bool holdsIdentity = false)
{
    naive::Fractal fractal;
    fractal.maps = std::move(maps);
    fractal.sets.push_back({{}, holdsIdentity});
    for (std::size_t i = 0; i < fractal.maps.size(); ++i) {
        fractal.sets[0].maps.push_back(static_cast<int>(i));
    }
    for (int i = 0; i < levels; ++i) {
        fractal.items.push_back({0, 0, {}});
    }
    return fractal;
}

/// Six steps round a hexagon, each to a half: of 36 pairs many meet.
std::vector<AffineMap> hexagon()
{
    std::vector<AffineMap> maps;
    for (int i = 0; i < 6; ++i) {
        const double angle = i * 60.0 * 3.14159265358979323846 / 180.0;
        maps.push_back(mapFromParts({std::cos(angle), std::sin(angle), 0.3}, {0, 0, 0}, {0.5, 0.5, 0.5}));
    }
    return maps;
}

/// Turns about one axis, which commute about the origin.
std::vector<AffineMap> turns()
{
    std::vector<AffineMap> maps;
    for (const double angle : {0.0, 20.0, 45.0, 90.0}) {
        maps.push_back(mapFromParts({0, 0, 0}, {0, 0, angle}, {0.7, 0.7, 0.7}));
    }
    return maps;
}

Built built(const naive::Fractal &fractal, const Mesh &mesh)
{
    auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
    BoxBounds boxes(*graph, mesh);
    return {std::move(*graph), std::move(boxes)};
}

bool isMet(const EqualProducts &products, const naive::Picks &picks)
{
    for (std::size_t i = 1; i < picks.size(); ++i) {
        for (const auto &[set, map] : products.leftOutAfter(0, static_cast<std::uint32_t>(picks[i - 1]))) {
            if (static_cast<int>(map) == picks[i]) {
                return false;
            }
        }
    }
    return true;
}

/// Where the copy of a word has three points, to 12 digits.
std::vector<long long> placeOf(const naive::Fractal &fractal, const naive::Picks &picks)
{
    std::vector<long long> place;
    for (const glm::dvec3 &point : {glm::dvec3(0), glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
        for (const Wide &coordinate : placed(picks, fractal.maps, point)) {
            place.push_back(std::llround(static_cast<long double>(coordinate) * 1e12L));
        }
    }
    return place;
}

}

class TestEqualProducts : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyPlaceIsMet_data();
    void everyPlaceIsMet();
    void whatIsFarSmallerThanItsMeshStays();
    void distancesStay_data();
    void distancesStay();
    void nothingIsLeftOutOfOthers();
    void nothingIsLeftOutWhereMapsAreShared();
};

void TestEqualProducts::everyPlaceIsMet_data()
{
    QTest::addColumn<std::vector<AffineMap>>("maps");
    QTest::addColumn<int>("most");
    QTest::newRow("translations that commute") << hexagon() << 800;
    QTest::newRow("turns that commute") << turns() << 40;
}

void TestEqualProducts::everyPlaceIsMet()
{
    QFETCH(const std::vector<AffineMap>, maps);
    QFETCH(const int, most);
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces.push_back({0, 1, 2});
    for (const bool holdsIdentity : {false, true}) {
        const naive::Fractal fractal = repeated(maps, 4, holdsIdentity);
        const Built it = built(fractal, mesh);
        const EqualProducts products(it.graph);
        std::set<std::vector<long long>> all;
        std::set<std::vector<long long>> met;
        int metCount = 0;
        for (const naive::Picks &picks : naive::allPicks(fractal.levels())) {
            const std::vector<long long> place = placeOf(fractal, picks);
            all.insert(place);
            if (isMet(products, picks)) {
                met.insert(place);
                ++metCount;
            }
        }
        QVERIFY(met == all);
        QVERIFY2(metCount <= (holdsIdentity ? 2 : 1) * most, qPrintable(QString::number(metCount)));
        QVERIFY(products.error() < 1e-13);
    }
}

void TestEqualProducts::distancesStay_data()
{
    QTest::addColumn<std::vector<AffineMap>>("maps");
    QTest::newRow("translations that commute") << hexagon();
    QTest::newRow("turns that commute") << turns();
}

void TestEqualProducts::distancesStay()
{
    QFETCH(const std::vector<AffineMap>, maps);
    std::mt19937_64 random(seed(1));
    const Mesh mesh = randomMesh(random);
    const Built it = built(repeated(maps, 4, true), mesh);
    const auto exact = ExactCollider::create(it.graph, it.boxes, mesh);
    const SimpleCollider simple(it.graph, mesh);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = randomPoint(random, 3.0);
        Hit one;
        Hit other;
        Hit placed;
        simple.search()->closest({p}, one);
        exact->search()->closest({p}, other);
        exact->searchPlaced({})->closest({p}, placed);
        for (const Hit &hit : {other, placed}) {
            QVERIFY(std::abs(hit.distance - one.distance) <= 1e-14);
            QVERIFY(hit.lower <= one.distance);
        }
    }
}

/// What is alike is so in parts of what is placed there, whatever the mesh's own size is.
void TestEqualProducts::whatIsFarSmallerThanItsMeshStays()
{
    std::mt19937_64 random(seed(3));
    for (const double shrinking : {1.0, 1e-6, 1e-9, 1e-12, 1e-15}) {
        naive::Fractal fractal = repeated(turns(), 3);
        fractal.maps.push_back({glm::dmat3(shrinking), glm::dvec3(0.3, 0, 0)});
        fractal.sets.push_back({{4}, false});
        fractal.items.push_back({0, 1, {}});
        Mesh mesh = randomMesh(random);
        for (glm::dvec3 &vertex : mesh.vertices) {
            vertex /= shrinking;
        }
        const Built it = built(fractal, mesh);
        const auto exact = ExactCollider::create(it.graph, it.boxes, mesh);
        const SimpleCollider simple(it.graph, mesh);
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p = randomPoint(random, 2.0);
            Hit least;
            simple.search()->closest({p}, least);
            for (const auto &search : {exact->search(), exact->searchPlaced({})}) {
                Hit hit;
                search->closest({p}, hit);
                QVERIFY(std::abs(hit.distance - least.distance) <= 1e-13);
                QVERIFY(hit.lower <= least.distance && hit.lower >= least.distance - 1e-11);
                QVERIFY(hit.face != Mesh::none);
            }
        }
    }
}

void TestEqualProducts::nothingIsLeftOutOfOthers()
{
    std::mt19937_64 random(seed(2));
    for (int i = 0; i < 300; ++i) {
        const RandomFractal sample = randomFractalWithMesh(random, 0.8);
        const EqualProducts products(sample.graph);
        for (SetId set = 0; set < sample.graph.setCount(); ++set) {
            const auto &maps = sample.graph.set(set).maps;
            for (std::uint32_t map = 0; map < maps.size(); ++map) {
                for (const auto &[next, other] : products.leftOutAfter(set, map)) {
                    // another pair has the same product
                    const AffineMap product = maps[map] * sample.graph.set(next).maps[other];
                    int alike = 0;
                    for (const AffineMap &outer : maps) {
                        for (const AffineMap &inner : sample.graph.set(next).maps) {
                            const AffineMap candidate = outer * inner;
                            alike += glm::length(candidate.translation - product.translation)
                                    <= 1e-12 * (1.0 + glm::length(product.translation))
                                ? 1
                                : 0;
                        }
                    }
                    QVERIFY(alike > 1);
                }
            }
        }
    }
}

void TestEqualProducts::nothingIsLeftOutWhereMapsAreShared()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.faces.push_back({0, 1, 2});
    naive::Fractal fractal = repeated(hexagon(), 2);
    fractal.sets.push_back({{0, 1}, false});
    fractal.items.push_back({0, 1, {}});
    const Built it = built(fractal, mesh);
    QVERIFY(it.graph.setsShareMaps());
    const EqualProducts products(it.graph);
    for (std::uint32_t map = 0; map < 6; ++map) {
        QVERIFY(products.leftOutAfter(0, map).empty());
    }
}

ROMANESCO_TEST(TestEqualProducts)

}

#include "testequalproducts.moc"
