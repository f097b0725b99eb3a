// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/collide/exactcollider.h"
#include "core/scene/scenecollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/scene/randomscenes.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Vector = truth::Vector<Wide>;

constexpr double u = 0x1p-53;
constexpr double third = 1.0 / 3.0;
constexpr double corner = 2.0 / 3.0;

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
        mapFromParts(offset * glm::dvec3(1, -0.5, 0.25), isTurned ? glm::dvec3(10, 20, 30) : glm::dvec3(0), {1, 1, 1});
    const Mesh mesh = cube({});
    const SceneCollider collider =
        SceneCollider::create(sceneOf({{.model = modelOf(graphOf(dust(levels), mesh), mesh), .worldFromModel = place}}),
                              {})
            .value();
    const auto search = collider.search();
    const double leaf = std::pow(third, depth);
    std::mt19937_64 random(7);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = place(nearACopy(random, levels));
        Hit hit;
        search->closest({p}, hit);
        const Wide least = leavesTo(fromPlace(place, p), levels) * pow(Wide(third), depth);
        const auto off = static_cast<double>(abs(Wide(hit.distance) - least));
        // a turned place is gone back from by products, which round what is far
        const double most = isTurned && offset > 0.0 ? 4.0 * u * glm::length(p) : (depth == 5 ? 1e-13 : 1e-6) * leaf;
        QVERIFY2(off <= most, qPrintable(QStringLiteral("%1: %2 leaves").arg(i).arg(off / leaf)));
        QVERIFY(Wide(hit.lower) <= least
                && hit.distance - hit.lower <= 128.0 * u * (8.0 + glm::length(p)) + 1e-4 * leaf);
    }
}

/// Its copies stand 4,000,000 away from the origin: they are as far off as what is rounded there.
void TestFarAway::aMeshFarFromItsOriginIsProved()
{
    const glm::dvec3 far(1e9, -5e8, 25e7);
    const Mesh mesh = cube(far);
    naive::Fractal fractal = dust(5);
    fractal.sets[0].maps = {0, 3, 6};
    const FractalGraph graph = graphOf(fractal, mesh);
    const RandomFractal sample{fractal, mesh, graph};
    const BoxBounds boxes(graph, mesh);
    const auto collider = ExactCollider::create(graph, boxes, mesh);
    const double leaf = std::pow(third, 5);
    std::mt19937_64 random(8);
    for (const auto &search : {collider->search(), collider->searchPlaced({})}) {
        for (int i = 0; i < 10; ++i) {
            const glm::dvec3 p = leaf * far + randomPoint(random, 1.0);
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
