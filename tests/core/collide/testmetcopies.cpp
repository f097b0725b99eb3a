// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/metcopies.h"

#include <QTest>

#include "core/collide/equalproducts.h"
#include "core/collide/exactcollider.h"
#include "core/collide/relativeframes.h"
#include "core/collide/simplecollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// So many levels of one set, which may be passed over.
naive::Fractal repeated(std::vector<AffineMap> maps, int levels)
{
    naive::Fractal fractal;
    fractal.maps = std::move(maps);
    fractal.sets.push_back({{}, true});
    for (std::size_t i = 0; i < fractal.maps.size(); ++i) {
        fractal.sets[0].maps.push_back(static_cast<int>(i));
    }
    fractal.items.assign(static_cast<std::size_t>(levels), {0, 0, {}});
    return fractal;
}

AffineMap step(const glm::dvec3 &to, double shrinking)
{
    return mapFromParts(to, {0, 0, 0}, glm::dvec3(shrinking));
}

/// Words of any length meet, as (1, 2, 2, 3) and (2, 1, 1, 0): six steps round a hexagon, each to a half.
std::vector<AffineMap> hexagon()
{
    std::vector<AffineMap> maps;
    for (int i = 0; i < 6; ++i) {
        const double angle = i * 60.0 * 3.14159265358979323846 / 180.0;
        maps.push_back(step({std::cos(angle), std::sin(angle), -1.0}, 0.5));
    }
    return maps;
}

/// No two pairs meet, but triples do, as 4·1 + 2·0 + 10 is 4·0 + 2·0 + 14.
std::vector<AffineMap> digits()
{
    std::vector<AffineMap> maps;
    for (const double digit : {0.0, 1.0, 10.0, 11.0, 14.0}) {
        maps.push_back(step({0.05 * digit, 0.0, -0.2}, 0.5));
    }
    return maps;
}

/// In a plane that p may be in, mirror images: p is at one place in both, but goes another way.
std::vector<AffineMap> mirrored()
{
    std::vector<AffineMap> maps;
    for (const double side : {-1.0, 1.0}) {
        for (const double height : {-0.6, 0.1, 0.8}) {
            AffineMap map = mapFromParts({0.7, 0.2, height}, {10, 20, 30}, glm::dvec3(0.55));
            for (int column = 0; column < 3; ++column) {
                map.linear[column].x *= side;
            }
            map.translation.x *= side;
            maps.push_back(map);
        }
    }
    return maps;
}

/// Two steps.
std::vector<AffineMap> once()
{
    return {step({1, 0, -1}, 0.5), step({-1, 0, -1}, 0.5)};
}

/// The same twice, then lower by what rounding may be: seen from below, what is left out comes first.
std::vector<AffineMap> twice()
{
    std::vector<AffineMap> maps = once();
    for (const AffineMap &map : once()) {
        maps.push_back(map);
        maps.back().translation.z -= 0x1p-50;
    }
    return maps;
}

struct Built {
    FractalGraph graph;
    BoxBounds boxes;
};

Built built(const naive::Fractal &fractal, const Mesh &mesh)
{
    auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
    BoxBounds boxes(*graph, mesh);
    return {std::move(*graph), std::move(boxes)};
}

Mesh pyramid()
{
    Mesh mesh;
    mesh.vertices = {{0.3, 0, 0}, {-0.2, 0.2, 0}, {-0.1, -0.3, 0}, {0, 0, 0.4}};
    mesh.faces = {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return mesh;
}

}

class TestMetCopies : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distancesStay_data();
    void distancesStay();
    void copiesThatCoincideDoNotMultiply();
    void otherSizesAndMotionsAreOthers();
    void whatIsApartIsNoNearerThanTold();
};

void TestMetCopies::distancesStay_data()
{
    QTest::addColumn<std::vector<AffineMap>>("maps");
    QTest::addColumn<std::vector<AffineMap>>("alike");
    QTest::addColumn<int>("levels");
    QTest::newRow("pairs meet") << hexagon() << hexagon() << 4;
    QTest::newRow("triples meet") << digits() << digits() << 5;
    QTest::newRow("mirror images") << mirrored() << mirrored() << 4;
    QTest::newRow("the same but for rounding") << twice() << once() << 12;
}

/// From points that see many copies equally near, and from others, with and without a motion.
void TestMetCopies::distancesStay()
{
    QFETCH(const std::vector<AffineMap>, maps);
    QFETCH(const std::vector<AffineMap>, alike);
    QFETCH(const int, levels);
    std::mt19937_64 random(seed(1));
    const Mesh mesh = pyramid();
    const Built it = built(repeated(maps, levels), mesh);
    const auto exact = ExactCollider::create(it.graph, it.boxes, mesh);
    const Built other = built(repeated(alike, levels), mesh);
    const SimpleCollider simple(other.graph, mesh);
    const auto truth = simple.search();
    for (int i = 0; i < 50; ++i) {
        glm::dvec3 p = randomPoint(random, 2.5);
        p.x = i % 3 == 0 ? 0.0 : p.x;
        if (i % 3 == 1) {
            p *= glm::dvec3(0.7, 0.01, 0.0);
            p.z = it.boxes.at(it.graph, 0).least.z - std::pow(10.0, uniform(random, -4, -1));
        }
        for (const bool isMoving : {false, true}) {
            Query query{.p = p};
            if (isMoving) {
                query.motion = randomPoint(random, 1.0);
            }
            Hit least;
            truth->closest(query, least);
            for (const auto &search : {exact->search(), exact->searchPlaced({})}) {
                Hit hit;
                search->closest(query, hit);
                QCOMPARE(hit.promise, Promise::Exact);
                QCOMPARE(hit.isFound(), least.isFound());
                if (least.isFound()) {
                    QVERIFY2(std::abs(hit.distance - least.distance) <= 1e-14,
                             qPrintable(QString::number(hit.distance - least.distance)));
                    QVERIFY(hit.lower <= least.distance);
                    QVERIFY(least.distance - hit.lower <= 1e-10);
                }
            }
        }
    }
}

/// A few at each level touch what is nearest, by words that are ever more.
void TestMetCopies::copiesThatCoincideDoNotMultiply()
{
    std::mt19937_64 random(seed(2));
    const Mesh mesh = pyramid();
    for (const bool doPairsMeet : {false, true}) {
        const Built it = built(repeated(doPairsMeet ? hexagon() : digits(), 20), mesh);
        QCOMPARE(EqualProducts(it.graph).isEmpty(), !doPairsMeet);
        const auto exact = ExactCollider::create(it.graph, it.boxes, mesh);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 p{uniform(random, 0, 1), uniform(random, -0.5, 0.5),
                               it.boxes.at(it.graph, 0).least.z - uniform(random, 0.05, 1)};
            for (const auto &search : {exact->search(), exact->searchPlaced({})}) {
                Hit hit;
                search->closest({.p = p, .nodeBudget = 10'000}, hit);
                QVERIFY2(hit.cost.nodeVisits <= (doPairsMeet ? 150 : 600),
                         qPrintable(QString::number(hit.cost.nodeVisits)));
                QVERIFY(hit.distance - hit.lower <= 1e-10);
            }
        }
    }
}

void TestMetCopies::otherSizesAndMotionsAreOthers()
{
    using Frame = LocalFrames::Frame;
    const Mesh mesh = pyramid();
    const Built it = built(repeated(digits(), 3), mesh);
    const EqualProducts products(it.graph);
    MetCopies<LocalFrames> met(products);
    const Box box{glm::dvec3(-1.0), glm::dvec3(1.0)};
    const auto isMet = [&](StateId state, const Frame &frame) {
        return met.findOrKeep({.state = state}, frame, box, 3.0 * frame.unit).has_value();
    };
    const glm::dvec3 p{1, 2, 3};
    const Frame frame{.p = p, .unit = 0.5, .error = 1e-15};
    met.begin();
    QVERIFY(!isMet(1, frame));
    QVERIFY(isMet(1, frame));
    QVERIFY(isMet(1, {.p = p + glm::dvec3(1e-15, 0, 0), .unit = 0.5, .error = 1e-15}));
    const auto apart =
        met.findOrKeep({.state = 1}, {.p = p - glm::dvec3(0, 1e-12, 0), .unit = 0.5, .error = 1e-12}, box, 1.5);
    QVERIFY(apart && *apart >= 1.4e-12 && *apart <= 1.6e-12);
    QVERIFY(!isMet(2, frame));
    QVERIFY(!isMet(1, {.p = p + glm::dvec3(1e-14, 0, 0), .unit = 0.5, .error = 1e-15}));
    QVERIFY(isMet(1, {.p = p + glm::dvec3(1e-14, 0, 0), .unit = 0.5, .error = 1e-15}));
    met.begin();
    QVERIFY(!isMet(1, frame));
    QVERIFY(!isMet(1, {.p = p, .unit = 0.25, .error = 1e-15}));
    QVERIFY(!isMet(1, {.p = p, .unit = 0.5, .error = 1e-15, .motion = glm::dvec3(1, 0, 0)}));
    QVERIFY(!isMet(1, {.p = p, .unit = 0.5, .error = 1e-15, .motion = glm::dvec3(0, 1, 0)}));
    QVERIFY(isMet(1, {.p = p, .unit = 0.5, .error = 1e-15, .motion = glm::dvec3(0, 1, 0)}));
}

/// Any point of the box, from any p.
void TestMetCopies::whatIsApartIsNoNearerThanTold()
{
    std::mt19937_64 random(seed(3));
    for (int i = 0; i < 2'000; ++i) {
        const double far = std::pow(10.0, uniform(random, -2, 4));
        const double little = std::pow(10.0, uniform(random, -9, 0));
        const glm::dvec3 corner = randomPoint(random, 3.0);
        const Box box{corner, corner + glm::dvec3(1.0, 0.5, 0.25)};
        const glm::dvec3 inside = corner + box.size() * (0.5 + randomPoint(random, 0.5));
        const LocalFrames::Frame local{.p = randomPoint(random, far), .unit = uniform(random, 0.1, 2)};
        LocalFrames::Frame moved = local;
        moved.p += randomPoint(random, little);
        moved.unit *= 1.0 + uniform(random, -little, little);
        const double changed =
            std::abs(local.unit * glm::distance(local.p, inside) - moved.unit * glm::distance(moved.p, inside));
        QVERIFY(changed <= LocalFrames::apart(local, moved, box) + 1e-12 * far);

        RelativeFrames::Frame relative;
        relative.map = mapFromParts(randomPoint(random, far), randomPoint(random, 180), {1, 2, 0.5});
        RelativeFrames::Frame other = relative;
        other.map.translation += randomPoint(random, little);
        for (int column = 0; column < 3; ++column) {
            other.map.linear[column] += randomPoint(random, little);
        }
        const double shifted = glm::distance(relative.map(inside), other.map(inside));
        QVERIFY(shifted <= RelativeFrames::apart(relative, other, box) + 1e-12 * far);
    }
}

ROMANESCO_TEST(TestMetCopies)

}

#include "testmetcopies.moc"
