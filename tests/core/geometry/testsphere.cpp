// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/sphere.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <QTest>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/mesh.h"
#include "tests/core/geometry/wild.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

Sphere wildSphere(int least = -150, int greatest = 150)
{
    return {*wildVector(least, greatest), std::abs(*wildNumber(least, greatest))};
}

bool holdsExactly(const Sphere &outer, const Sphere &inner)
{
    return distance(exact(outer.centre), exact(inner.centre)) + Real(inner.radius) <= Real(outer.radius);
}

/// The smallest ball round points, by trying the circumscribed balls of all sets of up to four of them.
double smallestRadius(const std::vector<glm::dvec3> &points)
{
    const std::size_t n = points.size();
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](const glm::dvec3 &centre) {
        double radius = std::isfinite(centre.x + centre.y + centre.z) ? 0.0 : std::numeric_limits<double>::infinity();
        for (const glm::dvec3 &point : points) {
            radius = std::max(radius, glm::distance(centre, point));
        }
        best = std::min(best, radius);
    };
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i; j < n; ++j) {
            const glm::dvec3 u = points[j] - points[i];
            consider(points[i] + 0.5 * u);
            for (std::size_t k = j + 1; k < n; ++k) {
                const glm::dvec3 v = points[k] - points[i];
                const glm::dvec3 normal = glm::cross(u, v);
                const glm::dvec3 toCentre =
                    glm::cross(dot(u, u) * v - dot(v, v) * u, normal) / (-2.0 * dot(normal, normal));
                consider(points[i] + toCentre);
                for (std::size_t l = k + 1; l < n; ++l) {
                    const glm::dvec3 w = points[l] - points[i];
                    const glm::dmat3 rows = glm::transpose(glm::dmat3(u, v, w));
                    consider(points[i] + glm::inverse(rows) * (0.5 * glm::dvec3(dot(u, u), dot(v, v), dot(w, w))));
                }
            }
        }
    }
    return best;
}

}

class TestSphere : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anEnclosingSphereHoldsAll();
    void anEnclosingSphereHoldsPointsOfAnySize();
    void anEnclosingSphereIsNearlyTheSmallest();
    void anEnclosingSphereOfOneIsThatOne();
    void emptySpheresAreLeftOut();
    void whatNoDoubleHoldsIsInfinite();
    void manySpheresAreEnclosed();
    void aTransformedSphereHoldsTransformedPoints();
    void containmentIsNeverClaimedFalsely();
    void strayVerticesDoNotCount();
};

void TestSphere::anEnclosingSphereHoldsAll()
{
    QVERIFY(rc::check([] {
        std::vector<Sphere> spheres;
        const int count = *rc::gen::inRange(1, 12);
        for (int i = 0; i < count; ++i) {
            spheres.push_back(wildSphere());
        }
        const Sphere outer = enclosingSphere(spheres);
        for (const Sphere &sphere : spheres) {
            RC_ASSERT(holdsExactly(outer, sphere));
        }
        const glm::dvec3 centre = *wildVector();
        const Sphere about{centre, enclosingRadius(centre, spheres)};
        for (const Sphere &sphere : spheres) {
            RC_ASSERT(holdsExactly(about, sphere));
        }
    }));
}

void TestSphere::anEnclosingSphereHoldsPointsOfAnySize()
{
    QVERIFY(rc::check([] {
        const double size = std::pow(10.0, *rc::gen::inRange(-300, 150));
        const glm::dvec3 offset = *rc::gen::arbitrary<bool>() ? *wildVector(-3, 3) * size : glm::dvec3(0);
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 6; ++i) {
            points.push_back(offset + *wildVector(-3, 1) * size);
        }
        const Sphere outer = enclosingSphere(points);
        for (const glm::dvec3 &point : points) {
            RC_ASSERT(holdsExactly(outer, {point, 0}));
        }
    }));
}

void TestSphere::anEnclosingSphereIsNearlyTheSmallest()
{
    std::mt19937_64 random(seed(7));
    std::uniform_real_distribution<double> coordinate(-1, 1);
    double worst = 0;
    for (int round = 0; round < 300; ++round) {
        const double flatness = round % 3 == 0 ? 0.0 : 1.0;
        std::vector<glm::dvec3> points;
        for (int i = 0; i < 3 + round % 6; ++i) {
            points.emplace_back(coordinate(random), coordinate(random), flatness * coordinate(random));
        }
        worst = std::max(worst, enclosingSphere(points).radius / smallestRadius(points));
    }
    QVERIFY2(worst < 1.05, qPrintable(QString::number(worst)));
    QVERIFY(worst > 1.0 - 1e-12); // else the oracle errs

    // Two balls: half of the farthest apart that their points are.
    const Sphere pair = enclosingSphere(std::vector<Sphere>{{{0, 0, 0}, 1}, {{10, 0, 0}, 3}});
    QVERIFY(pair.radius >= 7.0 && pair.radius < 7.0 * 1.05);
}

void TestSphere::anEnclosingSphereOfOneIsThatOne()
{
    const Sphere one = enclosingSphere(std::vector<Sphere>{{{1, 2, 3}, 4}});
    QVERIFY(one.centre == glm::dvec3(1, 2, 3));
    QVERIFY(one.radius >= 4 && one.radius < 4 * (1 + 1e-14));
    const Sphere point = enclosingSphere(std::vector<glm::dvec3>{{0, 0, 0}});
    QVERIFY(point.radius == 0.0);
}

void TestSphere::emptySpheresAreLeftOut()
{
    QVERIFY(enclosingSphere(std::vector<Sphere>{}).isEmpty());
    QVERIFY(enclosingSphere(std::vector<Sphere>{Sphere{}, Sphere{}}).isEmpty());
    QVERIFY(enclosingRadius({1, 1, 1}, {}) == -1.0);
    const Sphere outer = enclosingSphere(std::vector<Sphere>{Sphere{}, {{5, 0, 0}, 1}, Sphere{{100, 0, 0}, -1}});
    QVERIFY(outer.centre == glm::dvec3(5, 0, 0));
    QVERIFY(contains({{0, 0, 0}, 1}, Sphere{}));
    QVERIFY(transformed({}, 1, Sphere{}).isEmpty());
}

void TestSphere::whatNoDoubleHoldsIsInfinite()
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Sphere &wrong : {Sphere{{0, 0, 0}, infinity}, Sphere{{0, 0, 0}, nan}, Sphere{{infinity, 0, 0}, 1},
                                Sphere{{0, nan, 0}, 1}, Sphere{{-infinity, nan, 0}, 0}}) {
        QCOMPARE(enclosingSphere(std::vector<Sphere>{{{1, 2, 3}, 4}, wrong, {{7, 8, 9}, 1}}).radius, infinity);
        QCOMPARE(enclosingRadius({1, 1, 1}, std::vector<Sphere>{wrong, {{1, 2, 3}, 4}}), infinity);
    }
    // Near the limit: what fits about the origin is held, and nothing crashes.
    for (const double size : {1e150, 1e160, 1e300, 1e307, 8e307, 1.7e308}) {
        const std::vector<Sphere> spheres{{{size, 0, 0}, 1}, {{-size, size, 0}, 1}, {{0, -size, size}, size / 3}};
        const Sphere outer = enclosingSphere(spheres);
        for (const Sphere &sphere : spheres) {
            QVERIFY(std::isinf(outer.radius) || holdsExactly(outer, sphere));
        }
        QVERIFY(size > 6e307 || std::isfinite(outer.radius));
    }
}

void TestSphere::manySpheresAreEnclosed()
{
    std::vector<Sphere> spheres;
    for (int i = 0; i < 50'000; ++i) {
        spheres.push_back({{std::sin(i), std::cos(i), 0.001 * i}, 0.5});
    }
    const Sphere outer = enclosingSphere(spheres);
    for (const Sphere &sphere : spheres) {
        QVERIFY(glm::distance(outer.centre, sphere.centre) + sphere.radius <= outer.radius);
    }
    QVERIFY(outer.radius < 1.06 * 25.55);
}

void TestSphere::aTransformedSphereHoldsTransformedPoints()
{
    QVERIFY(rc::check([] {
        const AffineMap map{*wildMatrix(), *wildVector()};
        const Sphere sphere = wildSphere();
        const Sphere image = transformed(map, operatorNorm(map.linear), sphere);
        const glm::dvec3 direction = *wildVector(-1, 1);
        const RealVector zero = {Real(0), Real(0), Real(0)};
        const Real length = distance(exact(direction), zero);
        RealVector point = exact(sphere.centre);
        for (std::size_t i = 0; length != 0 && i < 3; ++i) {
            point[i] += Real(direction[static_cast<int>(i)]) / length * Real(sphere.radius);
        }
        RC_ASSERT(distance(applied(map, point), exact(image.centre)) <= Real(image.radius));
    }));
}

void TestSphere::containmentIsNeverClaimedFalsely()
{
    QVERIFY(rc::check([] {
        const Sphere inner = wildSphere(-3, 3);
        Sphere outer = wildSphere(-3, 3);
        // Nearly touching from the inside, where only rounding decides.
        const Real needed = distance(exact(inner.centre), exact(outer.centre)) + Real(inner.radius);
        outer.radius = static_cast<double>(needed * (1 + Real(*rc::gen::inRange(-40, 40)) * 1e-16));
        if (contains(outer, inner)) {
            RC_ASSERT(holdsExactly(outer, inner));
        }
        RC_ASSERT(contains({outer.centre, outer.radius * (1 + 1e-13) + 1e-15 * glm::length(inner.centre)}, inner));
    }));
    QVERIFY(contains({{0, 0, 0}, 2}, {{0.5, 0, 0}, 1}));
    QVERIFY(!contains({{0, 0, 0}, 2}, {{1.5, 0, 0}, 1}));
    QVERIFY(!contains(Sphere{}, {{0, 0, 0}, 0}));
}

void TestSphere::strayVerticesDoNotCount()
{
    Mesh mesh;
    mesh.vertices = {{1e9, 0, 0}, {0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    QVERIFY(boundingSphere(mesh).isEmpty());
    mesh.faces.push_back({1, 2, 3});
    const Sphere sphere = boundingSphere(mesh);
    QVERIFY(sphere.radius < 1.2);
    for (const std::size_t i : {1u, 2u, 3u}) {
        QVERIFY(holdsExactly(sphere, {mesh.vertices[i], 0}));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestSphere)

#include "testsphere.moc"
