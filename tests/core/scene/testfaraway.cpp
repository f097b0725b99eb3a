// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/collide/exactcollider.h"
#include "core/scene/scenecollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/collide/sweeptruth.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Vector = truth::Vector<Wide>;

constexpr double u = 0x1p-53;
constexpr double third = 1.0 / 3.0;
constexpr double corner = 2.0 / 3.0;
const glm::dvec3 faraway(1e9, -5e8, 25e7);

Mesh cube(const glm::dvec3 &middle)
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back(middle + glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    }
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t one = 1u << (axis + 1) % 3;
        const std::uint32_t other = 1u << (axis + 2) % 3;
        for (const std::uint32_t side : {0u, 1u << axis}) {
            mesh.faces.push_back({side, side + one, side + one + other});
            mesh.faces.push_back({side, side + one + other, side + other});
        }
    }
    return mesh;
}

naive::Fractal dust(std::uint64_t depth)
{
    naive::Fractal fractal;
    fractal.sets.push_back({{}, false});
    for (int i = 0; i < 8; ++i) {
        fractal.maps.push_back(
            {glm::dmat3(third), corner * glm::dvec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)});
        fractal.sets[0].maps.push_back(i);
    }
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    return fractal;
}

/// Of Cantor's dust of the very numbers that its maps have, from p: by folding, and in leaves.
Wide leavesTo(Vector p, std::uint64_t depth)
{
    for (std::uint64_t level = 0; level < depth; ++level) {
        for (Wide &x : p) {
            x = (abs(x) - Wide(corner)) / Wide(third);
        }
    }
    Vector outside;
    Wide inside = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        outside[axis] = std::max(Wide(abs(p[axis]) - 1), Wide(0));
        inside = std::min(inside, Wide(1 - abs(p[axis])));
    }
    return inside > 0 ? inside : Wide(sqrt(truth::dot(outside, outside)));
}

/// What a rotation by place puts at p, by Cramer's rule: no matrix of doubles is quite a rotation.
Vector fromPlace(const AffineMap &place, const glm::dvec3 &p)
{
    const Vector to = truth::difference(wide(p), wide(place.translation));
    const Vector a = wide(place.linear[0]);
    const Vector b = wide(place.linear[1]);
    const Vector c = wide(place.linear[2]);
    const auto cross = [](const Vector &x, const Vector &y) {
        return Vector{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
    };
    const Wide volume = truth::dot(a, cross(b, c));
    return {truth::dot(to, cross(b, c)) / volume, truth::dot(to, cross(c, a)) / volume,
            truth::dot(to, cross(a, b)) / volume};
}

/// A small fractal at a place far away, which may be of any kind, with all its faces as they stand there.
struct FarItem {
    std::shared_ptr<const Scene> scene;
    SweepTruth truth;
};

FarItem randomFarItem(std::mt19937_64 &random)
{
    RandomFractal sample = randomFractalWithMesh(random, 0.6);
    AffineMap place = randomPlace(random);
    place.translation += faraway;
    FarItem item{sceneOf({{.model = modelOf(sample.graph, sample.mesh), .worldFromModel = place}}), {}};
    sample.fractal.maps.push_back(place);
    for (naive::Picks picks : naive::allPicks(sample.fractal.levels())) {
        picks.insert(picks.begin(), static_cast<int>(sample.fractal.maps.size()) - 1);
        item.truth.add(sample.fractal, sample.mesh, picks);
    }
    return item;
}

/// The corner of a copy, and past it by about its size.
glm::dvec3 nearACopy(std::mt19937_64 &random, std::uint64_t depth)
{
    glm::dvec3 p = randomPoint(random, 2.0);
    for (std::uint64_t level = 0; level < depth; ++level) {
        p = third * p + corner * glm::sign(randomPoint(random, 1.0));
    }
    return p;
}

}

class TestFarAway : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void copiesAreAsExactAsTheirPlace_data();
    void copiesAreAsExactAsTheirPlace();
    void anyPlaceIsAsExact_data();
    void anyPlaceIsAsExact();
    void spheresTouchWhereTheyAre_data();
    void spheresTouchWhereTheyAre();
    void anglesThatChangeALittleAreProved();
    void aMeshFarFromItsOriginIsProved();
};

void TestFarAway::copiesAreAsExactAsTheirPlace_data()
{
    QTest::addColumn<double>("offset");
    QTest::addColumn<bool>("isTurned");
    QTest::addColumn<int>("depth");
    for (const double offset : {0.0, 1e9}) {
        for (const bool isTurned : {false, true}) {
            for (const int depth : {5, 20}) {
                QTest::addRow("%g, %s, depth %d", offset, isTurned ? "turned" : "moved", depth)
                    << offset << isTurned << depth;
            }
        }
    }
}

void TestFarAway::copiesAreAsExactAsTheirPlace()
{
    QFETCH(const double, offset);
    QFETCH(const bool, isTurned);
    QFETCH(const int, depth);
    const auto levels = static_cast<std::uint64_t>(depth);
    const AffineMap place =
        mapFromParts(offset / 1e9 * faraway, isTurned ? glm::dvec3(10, 20, 30) : glm::dvec3(0), {1, 1, 1});
    const Mesh mesh = cube({});
    const SceneCollider collider =
        SceneCollider::create(sceneOf({{.model = modelOf(graphOf(dust(levels), mesh), mesh), .worldFromModel = place}}),
                              {})
            .value();
    const auto search = collider.search();
    const double leaf = std::pow(third, depth);
    std::mt19937_64 random(seed(7));
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = place(nearACopy(random, levels));
        Hit hit;
        search->closest({p}, hit);
        const Wide least = leavesTo(fromPlace(place, p), levels) * pow(Wide(third), depth);
        const auto off = static_cast<double>(abs(Wide(hit.distance) - least));
        const double most = (depth == 5 ? 1e-13 : 1e-6) * leaf;
        QVERIFY2(off <= most, qPrintable(QStringLiteral("%1: %2 leaves").arg(i).arg(off / leaf)));
        QVERIFY(Wide(hit.lower) <= least && hit.distance - hit.lower <= 1024.0 * u);
    }
}

void TestFarAway::anyPlaceIsAsExact_data()
{
    QTest::addColumn<ColliderKind>("kind");
    QTest::newRow("exact") << ColliderKind::Exact;
    QTest::newRow("simple") << ColliderKind::Simple;
}

/// Moved, turned, mirrored, sheared or flat.
void TestFarAway::anyPlaceIsAsExact()
{
    QFETCH(const ColliderKind, kind);
    std::mt19937_64 random(seed(9));
    for (int round = 0; round < 40; ++round) {
        const FarItem item = randomFarItem(random);
        const SceneCollider collider = SceneCollider::create(item.scene, {kind}).value();
        const auto search = collider.search();
        for (int i = 0; i < 10; ++i) {
            const Sweep at{.p = faraway + randomPoint(random, 8.0)};
            const Wide least = item.truth.distanceAt(at, 0.0);
            Hit hit;
            search->closest({at.p}, hit);
            const auto off = static_cast<double>(abs(Wide(hit.distance) - least));
            QVERIFY2(off <= 256.0 * u * 8.0, qPrintable(QStringLiteral("%1: %2 u").arg(round).arg(off / u)));
            QVERIFY(Wide(hit.lower) <= least && hit.distance - hit.lower <= 1e-11);
        }
    }
}

void TestFarAway::spheresTouchWhereTheyAre_data()
{
    anyPlaceIsAsExact_data();
}

/// Small spheres, which what is rounded far away would be large to: at the surface, and not before.
void TestFarAway::spheresTouchWhereTheyAre()
{
    QFETCH(const ColliderKind, kind);
    std::mt19937_64 random(seed(10));
    int touched = 0;
    for (int round = 0; round < 30; ++round) {
        const FarItem item = randomFarItem(random);
        const SceneCollider collider = SceneCollider::create(item.scene, {kind}).value();
        const auto search = collider.search();
        for (int i = 0; i < 8; ++i) {
            const auto &triangle = item.truth.triangles()[random() % item.truth.triangles().size()];
            const glm::dvec3 p = faraway + randomPoint(random, 8.0);
            const Sweep sweep{.p = p, .v = narrow(triangle[0]) - p, .time = 1.5, .radius = 1e-6};
            Touch touch;
            search->sweep(sweep, touch);
            const double until = std::min(touch.time, sweep.time);
            QVERIFY2(until - touch.lower <= 1e-11, qPrintable(QString::number(until - touch.lower)));
            QVERIFY(item.truth.leastUntil(sweep, touch.lower, 1.01 * sweep.radius) > sweep.radius - 1e-12);
            if (touch.isFound()) {
                ++touched;
                const Wide off = item.truth.distanceAt(sweep, touch.time) - sweep.radius;
                QVERIFY2(off < 1e-11, qPrintable(QString::number(static_cast<double>(off))));
            }
        }
    }
    QVERIFY2(touched > 50, qPrintable(QString::number(touched)));
}

/// Which a similarity may do by no more than similarityOf() lets it.
void TestFarAway::anglesThatChangeALittleAreProved()
{
    const Mesh mesh = cube({});
    constexpr double shear = 20.0 * u;
    const AffineMap place{glm::dmat3(1.0, shear, -shear, shear, 1.0, shear, -shear, shear, 1.0), {}};
    SweepTruth truth;
    for (const Mesh::Face &face : mesh.faces) {
        WideTriangle triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle[i] = placed({0}, {place}, mesh.vertices[face[i]]);
        }
        truth.add(triangle);
    }
    const auto scene = sceneOf({{.model = modelOf(mesh), .worldFromModel = place}});
    std::mt19937_64 random(seed(11));
    for (const ColliderKind kind : {ColliderKind::Exact, ColliderKind::Bvh, ColliderKind::Simple}) {
        const auto collider = SceneCollider::create(scene, {kind}).value();
        const auto search = collider.search();
        for (int i = 0; i < 200; ++i) {
            const Sweep at{.p = 1e3 * glm::sign(randomPoint(random, 1.0)) + randomPoint(random, 1.0)};
            const Wide least = truth.distanceAt(at, 0.0);
            Hit hit;
            search->closest({at.p}, hit);
            QVERIFY(Wide(hit.lower) <= least);
            search->closest({at.p, static_cast<double>(least) * (1.0 + 2.0 * u)}, hit);
            QVERIFY(hit.isFound());
        }
    }
}

/// Its copies stand 4,000,000 away from the origin: they are as far off as what is rounded there.
void TestFarAway::aMeshFarFromItsOriginIsProved()
{
    const Mesh mesh = cube(faraway);
    naive::Fractal fractal = dust(5);
    fractal.sets[0].maps = {0, 3, 6};
    const FractalGraph graph = graphOf(fractal, mesh);
    const RandomFractal sample{fractal, mesh, graph};
    const BoxBounds boxes(graph, mesh);
    const auto collider = ExactCollider::create(graph, boxes, mesh);
    const double leaf = std::pow(third, 5);
    std::mt19937_64 random(seed(8));
    for (const auto &search : {collider->search(), collider->searchPlaced({})}) {
        for (int i = 0; i < 10; ++i) {
            const glm::dvec3 p = leaf * faraway + randomPoint(random, 1.0);
            Hit hit;
            search->closest({p}, hit);
            const Wide least = distanceToAll(sample, p);
            QVERIFY(abs(Wide(hit.distance) - least) <= 8.0 * u * glm::length(p));
            QVERIFY(Wide(hit.lower) <= least && hit.distance - hit.lower <= 1024.0 * u * glm::length(p));
        }
    }
}

ROMANESCO_TEST(TestFarAway)
}

#include "testfaraway.moc"
