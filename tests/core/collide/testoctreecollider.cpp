// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/collide/octreecollider.h"

#include <QTest>

#include "core/collide/bvhcollider.h"
#include "core/fractal/copies.h"
#include "tests/core/collide/allocations.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Every copy's faces in one mesh.
Mesh writtenOut(const FractalGraph &graph, const Mesh &mesh)
{
    Mesh all;
    CopyWalk copies(graph);
    while (copies.next()) {
        const auto before = static_cast<std::uint32_t>(all.vertices.size());
        for (const glm::dvec3 &vertex : mesh.vertices) {
            all.vertices.push_back(copies.modelFromBase()(vertex));
        }
        for (const Mesh::Face &face : mesh.faces) {
            all.faces.push_back({face[0] + before, face[1] + before, face[2] + before});
        }
    }
    return all;
}

Box boxRound(const std::vector<glm::dvec3> &points)
{
    Box box{points.front(), points.front()};
    for (const glm::dvec3 &point : points) {
        box = {glm::min(box.least, point), glm::max(box.greatest, point)};
    }
    return box;
}

/// To the nearest of the twelve triangles of the walls.
Wide distanceToWalls(const Box &box, const glm::dvec3 &p)
{
    const auto corner = [&](unsigned i) {
        return glm::dvec3((i & 1u) ? box.greatest.x : box.least.x, (i & 2u) ? box.greatest.y : box.least.y,
                          (i & 4u) ? box.greatest.z : box.least.z);
    };
    Mesh walls;
    for (unsigned i = 0; i < 8; ++i) {
        walls.vertices.push_back(corner(i));
    }
    for (const auto &[a, b, c, d] : std::initializer_list<std::array<std::uint32_t, 4>>{{0, 1, 3, 2},
                                                                                        {4, 5, 7, 6},
                                                                                        {0, 1, 5, 4},
                                                                                        {2, 3, 7, 6},
                                                                                        {0, 2, 6, 4},
                                                                                        {1, 3, 7, 5}}) {
        walls.faces.push_back({a, b, c});
        walls.faces.push_back({a, c, d});
    }
    return distanceToMesh(walls, p);
}

/// 5.4 by the letter: the distance to the box that the way down ends with, and how many boxes were looked at.
std::pair<Wide, int> descended(std::vector<glm::dvec3> vertices, int depth, const glm::dvec3 &p)
{
    Box box = boxRound(vertices);
    int looks = 0;
    for (int level = 0; level < depth; ++level) {
        const glm::dvec3 middle = 0.5 * box.least + 0.5 * box.greatest;
        std::optional<Wide> least;
        Box nearest;
        std::vector<glm::dvec3> inNearest;
        for (const glm::bvec3 high :
             {glm::bvec3(0, 0, 0), glm::bvec3(1, 0, 0), glm::bvec3(0, 1, 0), glm::bvec3(1, 1, 0), glm::bvec3(0, 0, 1),
              glm::bvec3(1, 0, 1), glm::bvec3(0, 1, 1), glm::bvec3(1, 1, 1)}) {
            std::vector<glm::dvec3> inside;
            for (const glm::dvec3 &vertex : vertices) {
                if (glm::greaterThanEqual(vertex, middle) == high) {
                    inside.push_back(vertex);
                }
            }
            if (inside.empty()) {
                continue;
            }
            const Box part{glm::mix(box.least, middle, high), glm::mix(middle, box.greatest, high)};
            const Wide distance = distanceToWalls(part, p);
            ++looks;
            if (!least || distance < *least - 1e-25) {
                least = distance;
                nearest = part;
                inNearest = inside;
            }
        }
        box = nearest;
        vertices = inNearest;
    }
    return {distanceToWalls(box, p), looks};
}

}

class TestOctreeCollider : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void depthIsThreeTimesTheLogarithmToBaseEight_data();
    void depthIsThreeTimesTheLogarithmToBaseEight();
    void itDescendsAsTheDissertationSays_data();
    void itDescendsAsTheDissertationSays();
    void itIsWrongBothWays();
    void nothingIsPromised();
    void costsAreCounted();
    void manyFacesAreRefused();
    void memoryIsAsTold();
    void theOrderOfFacesDoesNotMatter();
    void searchesNeverAllocate();
    void buildingCanBeStopped();
    void meshesOfAnyShapeAreTaken();
};

void TestOctreeCollider::depthIsThreeTimesTheLogarithmToBaseEight_data()
{
    QTest::addColumn<std::uint64_t>("faces");
    QTest::addColumn<int>("depth");
    QTest::newRow("none") << std::uint64_t(0) << 0;
    QTest::newRow("one") << std::uint64_t(1) << 0;
    QTest::newRow("eight") << std::uint64_t(8) << 3;
    QTest::newRow("5.65, below the half") << std::uint64_t(5) << 2;
    QTest::newRow("5.65, above the half") << std::uint64_t(6) << 3;
    // figure 18, where 96 times the depth before it is rounded is the cost: 1,736, 1,714, 1,666 and 1,936
    QTest::newRow("object 1") << std::uint64_t(277'654) << 18;
    QTest::newRow("object 2") << std::uint64_t(237'664) << 18;
    QTest::newRow("object 3") << std::uint64_t(168'070) << 17;
    QTest::newRow("object 4") << std::uint64_t(1'176'490) << 20;
}

void TestOctreeCollider::depthIsThreeTimesTheLogarithmToBaseEight()
{
    QFETCH(std::uint64_t, faces);
    QFETCH(int, depth);
    QCOMPARE(OctreeCollider::depthFor(faces), depth);
}

void TestOctreeCollider::itDescendsAsTheDissertationSays_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("depth");
    QTest::newRow("cube") << "menger" << 0;
    QTest::newRow("Menger") << "menger" << 2;
    QTest::newRow("Sierpinski") << "sierpinski" << 3;
    QTest::newRow("two sets of 7") << "two-sets" << 1;
}

void TestOctreeCollider::itDescendsAsTheDissertationSays()
{
    QFETCH(QString, name);
    QFETCH(int, depth);
    const auto [description, mesh, graph] = sample(name, static_cast<std::uint64_t>(depth));
    const auto tree = OctreeCollider::create(graph, mesh);
    const auto search = tree->search();
    const Mesh all = writtenOut(graph, mesh);
    const Places places(all);
    QCOMPARE(tree->build().faces, all.faces.size());
    QCOMPARE(tree->build().depth, static_cast<int>(std::lround(3 * std::log(all.faces.size()) / std::log(8.0))));
    std::mt19937_64 random(seed(1));
    Hit hit;
    for (int i = 0; i < 25; ++i) {
        const glm::dvec3 p = places(random, i % 2 == 0 ? Place::Uniform : Place::Near);
        search->closest({p}, hit);
        const auto [truth, looks] = descended(all.vertices, tree->build().depth, p);
        QVERIFY(abs(hit.distance - truth) <= 1e-14);
        QCOMPARE(hit.cost.faceTests, static_cast<std::uint64_t>(12 * looks));
        QCOMPARE(hit.cost.nodeVisits, static_cast<std::uint64_t>(tree->build().depth));
        QVERIFY(std::abs(glm::distance(hit.point, p) - hit.distance) <= 1e-14);
        QVERIFY(glm::distance(hit.point + hit.distance * hit.direction, p) <= 1e-14);
    }
}

void TestOctreeCollider::itIsWrongBothWays()
{
    const auto [description, mesh, graph] = sample(QStringLiteral("two-sets"), 2);
    const auto tree = OctreeCollider::create(graph, mesh);
    const Mesh all = writtenOut(graph, mesh);
    const auto oracle = BvhCollider::create(all);
    const Places places(all);
    std::mt19937_64 random(seed(2));
    int farther = 0;
    int nearer = 0;
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 p = places(random, i % 2 == 0 ? Place::Uniform : Place::Near);
        Hit hit;
        Hit truth;
        tree->search()->closest({p}, hit);
        oracle->search()->closest({p}, truth);
        farther += hit.distance > truth.distance * (1 + 1e-6) ? 1 : 0;
        nearer += hit.distance < truth.distance * (1 - 1e-6) ? 1 : 0;
    }
    QVERIFY(farther + nearer >= 260); // 52 %
    QVERIFY(farther > 0 && nearer > 0);
}

void TestOctreeCollider::nothingIsPromised()
{
    const auto [description, mesh, graph] = sample(QStringLiteral("menger"), 1);
    const auto tree = OctreeCollider::create(graph, mesh);
    Hit hit;
    tree->search()->closest({{3, 1, 1}}, hit);
    QVERIFY(hit.isFound() && hit.promise == Promise::None && hit.lower == 0.0);
    QVERIFY(hit.face == Mesh::none && hit.address.empty());
    const double distance = hit.distance;
    tree->search()->closest({{3, 1, 1}, 0.99 * distance}, hit);
    QVERIFY(!hit.isFound() && hit.promise == Promise::None && hit.lower == 0.0);
    tree->search()->closest({{3, 1, 1}, distance}, hit);
    QVERIFY(hit.isFound());
}

void TestOctreeCollider::costsAreCounted()
{
    const auto [description, mesh, graph] = sample(QStringLiteral("menger"), 0);
    const auto tree = OctreeCollider::create(graph, mesh);
    // a cube: 8 corners, an octant for each, and 3 more levels with a corner alone
    QCOMPARE(tree->build().faces, 12u);
    QCOMPARE(tree->build().vertices, 8u);
    QCOMPARE(tree->build().depth, 4);
    QCOMPARE(tree->build().nodes, 9u);
    QCOMPARE(tree->build().placements, 8u);
    Hit hit;
    tree->search()->closest({{3, 2, 1}}, hit);
    QCOMPARE(hit.cost.faceTests, 12u * (8 + 3));
    QCOMPARE(hit.cost.nodeVisits, 4u);
}

void TestOctreeCollider::manyFacesAreRefused()
{
    // 12·20^5
    const auto [description, mesh, graph] = sample(QStringLiteral("menger"), 5);
    const auto tree = OctreeCollider::create(graph, mesh);
    QVERIFY(!tree);
    QCOMPARE(tree.error(), std::string("38400000 faces are too many for an octree (at most 10000000)"));
    const auto [deep, same, graphOfDeep] = sample(QStringLiteral("menger"), 1'000'000'000);
    QVERIFY(!OctreeCollider::create(graphOfDeep, same));
}

void TestOctreeCollider::memoryIsAsTold()
{
    for (const char *name : {"sierpinski", "two-sets"}) {
        const auto [description, mesh, graph] = sample(QLatin1String(name), 2);
        const std::size_t before = bytesAllocated();
        const auto tree = OctreeCollider::create(graph, mesh);
        QCOMPARE(tree->memoryUse() - sizeof(OctreeCollider), bytesAllocated() - before);
        // 8 bytes a node, 24 a vertex at most
        QVERIFY(tree->memoryUse() - sizeof(OctreeCollider) <= 8 * tree->build().nodes + 24 * tree->build().vertices);
    }
}

void TestOctreeCollider::theOrderOfFacesDoesNotMatter()
{
    std::mt19937_64 random(seed(3));
    const Mesh mesh = ball(20);
    Mesh shuffled = mesh;
    std::ranges::reverse(shuffled.vertices);
    for (Mesh::Face &face : shuffled.faces) {
        for (std::uint32_t &index : face) {
            index = static_cast<std::uint32_t>(mesh.vertices.size()) - 1 - index;
        }
    }
    std::ranges::shuffle(shuffled.faces, random);
    shuffled.vertices.push_back({100, 0, 0}); // of no face
    const FractalGraph graph = FractalGraph::ofMesh(boundingSphere(mesh));
    const auto one = OctreeCollider::create(graph, mesh);
    const auto other = OctreeCollider::create(graph, shuffled);
    const Places places(mesh);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = places(random, i % 2 == 0 ? Place::Uniform : Place::Near);
        Hit a;
        Hit b;
        one->search()->closest({p}, a);
        other->search()->closest({p}, b);
        QVERIFY(a.distance == b.distance && a.point == b.point && a.direction == b.direction);
        QVERIFY(a.cost.faceTests == b.cost.faceTests);
    }
}

void TestOctreeCollider::searchesNeverAllocate()
{
    const auto [description, mesh, graph] = sample(QStringLiteral("two-sets"), 1);
    const auto tree = OctreeCollider::create(graph, mesh);
    const auto search = tree->search();
    Hit hit;
    std::mt19937_64 random(seed(4));
    const std::size_t before = allocationCount();
    for (int i = 0; i < 100; ++i) {
        search->closest({randomPoint(random, 10.0)}, hit);
    }
    QCOMPARE(allocationCount(), before);
}

void TestOctreeCollider::buildingCanBeStopped()
{
    std::stop_source stop;
    stop.request_stop();
    const auto [description, mesh, graph] = sample(QStringLiteral("menger"), 4);
    const auto tree = OctreeCollider::create(graph, mesh, stop.get_token());
    QVERIFY(!tree);
    QCOMPARE(tree.error(), std::string("cancelled"));
}

void TestOctreeCollider::meshesOfAnyShapeAreTaken()
{
    const auto ofMesh = [](const Mesh &mesh) {
        return OctreeCollider::create(FractalGraph::ofMesh(boundingSphere(mesh)), mesh);
    };
    Hit hit;
    const Mesh empty{{{1, 2, 3}}, {}};
    ofMesh(empty)->search()->closest({{0, 0, 0}}, hit);
    QVERIFY(!hit.isFound());
    const Mesh point{{{1, 2, 3}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
    ofMesh(point)->search()->closest({{1, 2, 5}}, hit);
    QCOMPARE(hit.distance, 2.0);
    ofMesh(point)->search()->closest({{1, 2, 3}}, hit);
    QVERIFY(hit.distance == 0.0 && hit.direction == glm::dvec3(0, 1, 0));
    Mesh huge = ball(6);
    for (glm::dvec3 &vertex : huge.vertices) {
        vertex *= 0.9e300;
    }
    ofMesh(huge)->search()->closest({{1e300, 0, 0}}, hit);
    QVERIFY(hit.distance > 1e298 && hit.distance < 2e300);
    huge.vertices[huge.faces[3][1]].z = std::nan("");
    QVERIFY(!ofMesh(huge));
}

}

ROMANESCO_TEST(romanesco::test::TestOctreeCollider)

#include "testoctreecollider.moc"
