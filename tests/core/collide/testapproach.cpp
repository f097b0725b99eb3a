// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/collide/bvhcollider.h"
#include "core/collide/exactcollider.h"
#include "core/collide/greedycollider.h"
#include "core/collide/octreecollider.h"
#include "core/collide/simplecollider.h"
#include "core/collide/writtenout.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of all faces of all copies, the nearest that p comes nearer to. What is beside p may be counted or not.
struct Ahead {
    double atLeast = infinity;
    double atMost = infinity;
};
Ahead ahead(const RandomFractal &sample, const glm::dvec3 &p, const glm::dvec3 &motion)
{
    constexpr double beside = 1e-9;
    Ahead least;
    for (const naive::Picks &picks : naive::allPicks(sample.fractal.levels())) {
        for (const Mesh::Face &face : sample.mesh.faces) {
            std::array<truth::Vector<Wide>, 3> triangle;
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = placed(picks, sample.fractal.maps, sample.mesh.vertices[face[i]]);
            }
            const truth::Vector<Wide> way = truth::wayFrom<Wide>(triangle, wide(p));
            const auto distance = static_cast<double>(sqrt(truth::dot(way, way)));
            const auto along = static_cast<double>(truth::dot(way, wide(motion)));
            const double most = distance * glm::length(motion);
            least.atLeast = along < beside * most ? std::min(least.atLeast, distance) : least.atLeast;
            least.atMost = along < -beside * most ? std::min(least.atMost, distance) : least.atMost;
        }
    }
    return least;
}

void requireAhead(const Hit &hit, const Ahead &truth, const glm::dvec3 &motion, double size)
{
    QVERIFY2(hit.distance >= truth.atLeast * (1 - 1e-12) - 1e-13 * size,
             qPrintable(QString::number(hit.distance - truth.atLeast)));
    QVERIFY2(hit.distance <= truth.atMost * (1 + 1e-12) + 1e-13 * size,
             qPrintable(QString::number(hit.distance - truth.atMost)));
    QVERIFY(hit.lower <= truth.atMost + 1e-13 * size);
    QVERIFY(!hit.isFound() || glm::dot(hit.direction, motion) < 1e-8 * glm::length(motion));
}

}

class TestApproach : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whatIsAheadIsFound_data();
    void whatIsAheadIsFound();
    void largeMeshesAreAsked();
    void whatIsBehindCostsNothing();
    void onAFaceTheDirectionIsAgainstTheMotion();
    void everyKindFindsWhatIsAhead();
    void nothingWithinTheRadiusIsAhead();
};

void TestApproach::whatIsAheadIsFound_data()
{
    QTest::addColumn<double>("largest");
    QTest::newRow("shrinking") << 0.7;
    QTest::newRow("growing") << 2.0;
}

/// By all that promise something, of random fractals with maps of every kind.
void TestApproach::whatIsAheadIsFound()
{
    QFETCH(const double, largest);
    std::mt19937_64 random(seed(1));
    int found = 0;
    for (int i = 0; i < 200; ++i) {
        const RandomFractal sample = randomFractalWithMesh(random, largest);
        const BoxBounds boxes(sample.graph, sample.mesh);
        const auto exact = ExactCollider::create(sample.graph, boxes, sample.mesh);
        const SimpleCollider simple(sample.graph, sample.mesh);
        const auto all = writtenOut(sample.graph, sample.mesh, {}, 1'000'000);
        const auto bvh = BvhCollider::create(*all);
        const double size = std::max(sample.graph.bound(0).radius, 1e-3);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 p = sample.graph.bound(0).centre + randomPoint(random, 1.2 * size);
            const glm::dvec3 motion = randomPoint(random, k % 2 == 0 ? 1.0 : 1e-9);
            const Ahead truth = ahead(sample, p, motion);
            for (const auto &search : {exact->search(), exact->searchPlaced({}), simple.search(), bvh->search()}) {
                Hit hit;
                search->closest({.p = p, .motion = motion}, hit);
                requireAhead(hit, truth, motion, glm::length(p) + size);
                QCOMPARE(hit.promise, Promise::Exact);
                found += hit.isFound() ? 1 : 0;
            }
        }
    }
    QVERIFY2(found > 1000, qPrintable(QString::number(found)));
}

/// Such as are searched by a tree of faces.
void TestApproach::largeMeshesAreAsked()
{
    std::mt19937_64 random(seed(2));
    RandomFractal sample = randomFractalWithMesh(random, 0.6);
    for (int i = 0; i < 10; ++i) {
        Mesh mesh;
        for (std::uint32_t k = 0; k < 50; ++k) {
            for (int corner = 0; corner < 3; ++corner) {
                mesh.vertices.push_back(randomPoint(random, 1.0));
            }
            mesh.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
        }
        sample.fractal = naive::Fractal{};
        sample.fractal.maps = {mapFromParts({1, 0, 0}, {10, 20, 30}, {0.5, 0.5, 0.5}),
                               mapFromParts({0, 1, 0}, {0, 50, 0}, {0.4, 0.4, 0.4})};
        sample.fractal.sets = {{{0, 1}, true}};
        sample.fractal.items = {{0, 0, {}}};
        sample.mesh = mesh;
        sample.graph = std::move(*FractalGraph::build(sample.fractal.description(), boundingSphere(mesh)));
        const BoxBounds boxes(sample.graph, mesh);
        const auto exact = ExactCollider::create(sample.graph, boxes, sample.mesh);
        for (int k = 0; k < 10; ++k) {
            const glm::dvec3 p = randomPoint(random, 1.5);
            const glm::dvec3 motion = randomPoint(random, 1.0);
            const Ahead truth = ahead(sample, p, motion);
            for (const auto &search : {exact->search(), exact->searchPlaced({})}) {
                Hit hit;
                search->closest({.p = p, .motion = motion}, hit);
                requireAhead(hit, truth, motion, 3.0);
            }
        }
    }
}

/// A point that leaves a fractal behind meets nothing, and sees that from outside.
void TestApproach::whatIsBehindCostsNothing()
{
    const Sample fractal = sample(QStringLiteral("menger"), 20);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto exact = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const glm::dvec3 p = fractal.graph.bound(0).centre + glm::dvec3(3.0 * fractal.graph.bound(0).radius, 0.1, 0.2);
    for (const auto &search : {exact->search(), exact->searchPlaced({})}) {
        Hit hit;
        search->closest({.p = p, .motion = glm::dvec3(1, 0, 0)}, hit);
        QVERIFY(!hit.isFound());
        QCOMPARE(hit.cost.nodeVisits, std::uint64_t{1});
        QCOMPARE(hit.cost.faceTests, std::uint64_t{0});
        search->closest({.p = p, .motion = glm::dvec3(-1, 0, 0)}, hit);
        Hit nearest;
        search->closest({p}, nearest);
        QCOMPARE(hit.distance, nearest.distance);
    }
}

void TestApproach::onAFaceTheDirectionIsAgainstTheMotion()
{
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    mesh.faces.push_back({0, 1, 2});
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(mesh));
    const BoxBounds boxes(graph, mesh);
    const auto exact = ExactCollider::create(graph, boxes, mesh);
    const SimpleCollider simple(graph, mesh);
    const auto bvh = BvhCollider::create(mesh);
    for (const auto &search : {exact->search(), exact->searchPlaced({}), simple.search(), bvh->search()}) {
        Hit hit;
        for (const double z : {-1.0, 1.0}) {
            search->closest({.p = {1, 1, 0}, .motion = glm::dvec3(1, 0, z)}, hit);
            QCOMPARE(hit.distance, 0.0);
            QCOMPARE(hit.direction, glm::dvec3(0, 0, -z));
        }
        search->closest({.p = {1, 1, 0}, .motion = glm::dvec3(1, 1, 0)}, hit); // along the face
        QVERIFY(!hit.isFound());
    }
}

/// Also those that promise less: what they find is ahead, and no nearer than what is, but for what they round away from it.
void TestApproach::everyKindFindsWhatIsAhead()
{
    std::mt19937_64 random(seed(3));
    const Sample fractal = sample(QStringLiteral("tree"), 3);
    const SimpleCollider simple(fractal.graph, fractal.mesh);
    const auto greedy = GreedyCollider::create(fractal.graph, fractal.mesh);
    const auto octree = OctreeCollider::create(fractal.graph, fractal.mesh);
    const double size = fractal.graph.bound(0).radius;
    int found = 0;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 p = fractal.graph.bound(0).centre + randomPoint(random, size);
        const glm::dvec3 motion = randomPoint(random, 1.0);
        Hit least;
        Hit hit;
        simple.search()->closest({.p = p, .motion = motion}, least);
        greedy->search()->closest({.p = p, .motion = motion}, hit);
        QVERIFY(!hit.isFound()
                || (hit.distance >= least.distance - 1e-12 * size && glm::dot(hit.direction, motion) < 0.0));
        octree->search()->closest({.p = p, .motion = motion}, hit);
        QVERIFY(!hit.isFound() || glm::dot(hit.direction, motion) < 0.0);
        found += hit.isFound() ? 1 : 0;
    }
    QVERIFY(found > 10 && found < 100);
}

void TestApproach::nothingWithinTheRadiusIsAhead()
{
    const Sample fractal = sample(QStringLiteral("menger"), 4);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto exact = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    const Sphere bound = fractal.graph.bound(0);
    const glm::dvec3 p = bound.centre + glm::dvec3(2.0 * bound.radius, 0.0, 0.0);
    Hit all;
    exact->search()->closest({.p = p, .motion = glm::dvec3(-1, 0, 0)}, all);
    QVERIFY(all.isFound());
    for (const double factor : {0.999, 1.001}) {
        Hit hit;
        exact->search()->closest({.p = p, .radius = factor * all.distance, .motion = glm::dvec3(-1, 0, 0)}, hit);
        QCOMPARE(hit.isFound(), factor > 1.0);
        QVERIFY(hit.lower <= all.distance);
        QVERIFY(hit.lower >= 0.998 * all.distance);
    }
}

ROMANESCO_TEST(TestApproach)

}

#include "testapproach.moc"
