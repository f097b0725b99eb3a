// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <array>
#include <thread>

#include <QTest>

#include "core/collide/exactcollider.h"
#include "tests/core/collide/bruteforce.h"
#include "tests/core/fractal/samples.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Vector = truth::Vector<Wide>;

Wide square(const Vector &v)
{
    return truth::dot(v, v);
}

const std::array<glm::dvec3, 4> corners{glm::dvec3(1, 1, 1), {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

/// A tetrahedron's copies in its corners, half as large: mirrored across the plane between two corners they are the same,
/// so what is nearest is in the copy of the corner that is nearest.
Wide sierpinskiDistance(Vector p, int depth)
{
    Wide unit = 1;
    for (int level = 0; level < depth; ++level) {
        const auto nearest = std::ranges::min_element(
            corners, {}, [&](const glm::dvec3 &corner) { return square(truth::difference(p, wide(corner))); });
        for (std::size_t axis = 0; axis < 3; ++axis) {
            p[axis] = 2 * p[axis] - (*nearest)[static_cast<int>(axis)];
        }
        unit /= 2;
    }
    Wide least = std::numeric_limits<double>::infinity();
    for (std::size_t left = 0; left < 4; ++left) {
        std::array<Vector, 3> face;
        for (std::size_t i = 0; i < 3; ++i) {
            face[i] = wide(corners[(left + 1 + i) % 4]);
        }
        least = std::min(least, truth::distance<Wide>(face, p));
    }
    return unit * least;
}

/// Of the walls of the cube from -1 to 1, from inside too.
Wide cubeDistance(const Vector &p)
{
    Vector outside;
    Wide inside = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        outside[axis] = std::max(Wide(abs(p[axis]) - 1), Wide(0));
        inside = std::min(inside, Wide(1 - abs(p[axis])));
    }
    return inside > 0 ? inside : Wide(sqrt(square(outside)));
}

/// The cube's copies in its corners, a third as large: along each axis by itself, to the nearer end.
Wide dustDistance(Vector p, int depth)
{
    Wide unit = 1;
    for (int level = 0; level < depth; ++level) {
        for (Wide &x : p) {
            x = 3 * abs(x) - 2;
        }
        unit /= 3;
    }
    return unit * cubeDistance(p);
}

/// The cube's copies at its corners and edges, a third as large. The planes through the middle mirror the sponge, along
/// the axes and the diagonals, and those between a corner and the edges beside it mirror what is near: so what is nearest
/// is on the same side of each as p.
Wide mengerDistance(Vector p, int depth)
{
    Wide unit = 1;
    for (int level = 0; level < depth; ++level) {
        for (Wide &x : p) {
            x = abs(x);
        }
        std::ranges::sort(p);
        p = {3 * p[0] - (3 * p[0] > 1 ? 2 : 0), 3 * p[1] - 2, 3 * p[2] - 2};
        unit /= 3;
    }
    return unit * cubeDistance(p);
}

struct Folded {
    Mesh mesh;
    naive::Fractal fractal;
};

naive::Fractal repeated(std::vector<AffineMap> maps, std::uint64_t depth)
{
    naive::Fractal fractal;
    fractal.maps = std::move(maps);
    fractal.sets.push_back({{}, false});
    for (std::size_t i = 0; i < fractal.maps.size(); ++i) {
        fractal.sets[0].maps.push_back(static_cast<int>(i));
    }
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    return fractal;
}

Folded sierpinski(std::uint64_t depth)
{
    Mesh mesh;
    mesh.vertices.assign(corners.begin(), corners.end());
    for (const Mesh::Face &face : {Mesh::Face{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}) {
        mesh.faces.push_back(face);
    }
    std::vector<AffineMap> maps;
    for (const glm::dvec3 &corner : corners) {
        maps.push_back({glm::dmat3(0.5), 0.5 * corner});
    }
    return {mesh, repeated(maps, depth)};
}

/// The cube's copies, a third as large, at those of its 27 places that are off its middle along so many axes or more.
Folded thirds(std::uint64_t depth, int leastOff)
{
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t u = 1u << (axis + 1) % 3;
        const std::uint32_t v = 1u << (axis + 2) % 3;
        for (const std::uint32_t side : {0u, 1u << axis}) {
            mesh.faces.push_back({side, side + u, side + u + v});
            mesh.faces.push_back({side, side + u + v, side + v});
        }
    }
    std::vector<AffineMap> maps;
    for (int i = 0; i < 27; ++i) {
        const glm::dvec3 place(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
        if (glm::dot(place, place) >= leastOff) {
            maps.push_back({glm::dmat3(1.0 / 3.0), 2.0 / 3.0 * place});
        }
    }
    return {mesh, repeated(maps, depth)};
}

enum class Shape { Sierpinski, Dust, Menger };

Folded folded(Shape shape, std::uint64_t depth)
{
    return shape == Shape::Sierpinski ? sierpinski(depth) : thirds(depth, shape == Shape::Dust ? 3 : 2);
}

Wide foldedDistance(Shape shape, const Vector &p, int depth)
{
    return shape == Shape::Sierpinski ? sierpinskiDistance(p, depth)
        : shape == Shape::Dust        ? dustDistance(p, depth)
                                      : mengerDistance(p, depth);
}

}

class TestFolds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void deepFractalsAreAsFarAsTheirFolds_data();
    void deepFractalsAreAsFarAsTheirFolds();
    void threadsFindTheSame();
};

void TestFolds::deepFractalsAreAsFarAsTheirFolds_data()
{
    QTest::addColumn<Shape>("shape");
    QTest::addColumn<int>("depth");
    const std::pair<const char *, Shape> shapes[]{{"Sierpinski", Shape::Sierpinski},
                                                  {"Cantor dust", Shape::Dust},
                                                  {"Menger", Shape::Menger}};
    for (const auto &[name, shape] : shapes) {
        for (const int depth : {1, 2, 5, 10, 20, 30, 40}) {
            QTest::addRow("%s, depth %d", name, depth) << shape << depth;
        }
    }
}

/// Uniform points, and such as are ever nearer to the surface.
void TestFolds::deepFractalsAreAsFarAsTheirFolds()
{
    QFETCH(const Shape, shape);
    QFETCH(const int, depth);
    std::mt19937_64 random(seed(1));
    const auto [mesh, fractal] = folded(shape, static_cast<std::uint64_t>(depth));
    const auto graph = FractalGraph::build(fractal.description(), boundingSphere(mesh));
    const BoxBounds boxes(*graph, mesh);
    const auto collider = ExactCollider::create(*graph, boxes, mesh);
    for (const auto &search : {collider->search(), collider->searchPlaced({})}) {
        glm::dvec3 p(0.0);
        for (int i = 0; i < 200; ++i) {
            Hit hit;
            p = i % 10 == 0 ? randomPoint(random, 1.5) : hit.point + 0.1 * (p - hit.point);
            search->closest({p}, hit);
            const Wide truth = foldedDistance(shape, wide(p), depth);
            // thirds are rounded, and so is each step down
            QVERIFY2(abs(Wide(hit.distance) - truth) <= Wide(4e-15 * (depth + 2)),
                     qPrintable(QStringLiteral("%1, but %2").arg(hit.distance).arg(static_cast<double>(truth))));
            QVERIFY(Wide(hit.lower) <= truth + Wide(1e-15));
            QCOMPARE(hit.promise, Promise::Exact);
        }
    }
}

void TestFolds::threadsFindTheSame()
{
    const Sample fractal = sample(QStringLiteral("appendix-b"), 6);
    const BoxBounds boxes(fractal.graph, fractal.mesh);
    const auto collider = ExactCollider::create(fractal.graph, boxes, fractal.mesh);
    std::mt19937_64 random(seed(2));
    std::vector<glm::dvec3> points(400);
    std::ranges::generate(points, [&] { return randomPoint(random, fractal.graph.bound(0).radius); });
    constexpr std::size_t threads = 4;
    std::array<std::vector<std::array<double, 5>>, threads> found;
    {
        std::vector<std::jthread> running;
        for (std::size_t thread = 0; thread < threads; ++thread) {
            running.emplace_back([&, thread] {
                const auto search = collider->search();
                found[thread].resize(points.size());
                for (std::size_t k = 0; k < points.size(); ++k) { // each from another one on
                    const std::size_t i = (k + thread * 100) % points.size();
                    Hit hit;
                    search->closest({points[i]}, hit);
                    found[thread][i] = {hit.distance, hit.point.x, hit.direction.y, hit.lower,
                                        static_cast<double>(hit.cost.nodeVisits)};
                }
            });
        }
    }
    for (const auto &ofThread : found) {
        QVERIFY(ofThread == found.front());
    }
}

ROMANESCO_TEST(TestFolds)

}

#include "testfolds.moc"
