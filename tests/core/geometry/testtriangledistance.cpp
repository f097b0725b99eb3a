// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/triangledistance.h"

#include "tests/core/geometry/triangles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

void requireWithinError(const TriangleDistance &found, const Triangle &triangle, const glm::dvec3 &p)
{
    const Real unit = Real(std::ldexp(largestOffset(triangle, p), -53));
    RC_ASSERT(Real(found.error) <= 32 * unit * (1 + 1e-12));
    RC_ASSERT(abs(Real(found.distance) - trueDistance(triangle, p)) <= Real(found.error));
}

}

class TestTriangleDistance : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void distancesAreWithinTheirError_data();
    void distancesAreWithinTheirError();
    void wellShapedTrianglesAreQuick();
    void sizesMayBeExtreme();
    void boundariesOfRegionsAreExact();
    void degenerateTrianglesHaveADistance();
};

void TestTriangleDistance::distancesAreWithinTheirError_data()
{
    addShapes();
}

void TestTriangleDistance::distancesAreWithinTheirError()
{
    QFETCH(Shape, shape);
    QVERIFY(rc::check([shape](std::uint32_t seed) {
        Draw draw(seed);
        for (int i = 0; i < 20; ++i) {
            const auto [triangle, p] = trianglePoint(shape, draw);
            if (const auto quick = quickDistance(triangle, p)) {
                requireWithinError(*quick, triangle, p);
            }
            requireWithinError(distanceTo(triangle, p), triangle, p);
        }
    }));
}

void TestTriangleDistance::wellShapedTrianglesAreQuick()
{
    Draw draw(1);
    int slow = 0;
    for (int i = 0; i < 10'000; ++i) {
        const auto [triangle, p] = trianglePoint(Shape::Plain, draw);
        slow += quickDistance(triangle, p) ? 0 : 1;
    }
    QVERIFY(slow < 100);
}

void TestTriangleDistance::sizesMayBeExtreme()
{
    QVERIFY(rc::check([] {
        const int least = *rc::gen::inRange(-280, 290);
        const auto vector = [least] { return *wildVector(least, least + 9); };
        const Triangle triangle{vector(), vector(), vector()};
        const glm::dvec3 p = vector();
        if (largestOffset(triangle, p) > 0.0) {
            requireWithinError(distanceTo(triangle, p), triangle, p);
        }
    }));
    for (const double size : {1e-300, 1e-160, 1e160, 1e300}) {
        const Triangle triangle{glm::dvec3(size, 0, 0), glm::dvec3(0, size, 0), glm::dvec3(0, 0, size)};
        QVERIFY(!quickDistance(triangle, glm::dvec3(0.0)));
        QVERIFY(std::abs(distanceTo(triangle, glm::dvec3(0.0)).distance / size - 1.0 / std::sqrt(3.0)) <= 1e-15);
    }
}

void TestTriangleDistance::boundariesOfRegionsAreExact()
{
    const Triangle triangle{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 0)};
    const auto distance = [&](double x, double y, double z) {
        return quickDistance(triangle, {x, y, z}).value().distance;
    };
    QCOMPARE(distance(1, 1, 3), 3.0);
    QCOMPARE(distance(0, 0, -2), 2.0);
    QCOMPARE(distance(-3, 0, 4), 5.0);
    QCOMPARE(distance(0, -5, 0), 5.0);
    QCOMPARE(distance(2, -5, 12), 13.0);
    QCOMPARE(distance(-1, 2, 0), 1.0);
    QCOMPARE(distance(7, 0, 4), 5.0);
    QCOMPARE(distance(0, 8, 3), 5.0);
    QCOMPARE(distance(3, 3, 0), std::sqrt(2.0));
    QCOMPARE(distance(1, 0.5, 0), 0.0);
}

void TestTriangleDistance::degenerateTrianglesHaveADistance()
{
    const glm::dvec3 a(1, 2, 3);
    QCOMPARE(distanceTo({a, a, a}, {1, 2, 5}).distance, 2.0);
    QCOMPARE(distanceTo({a, a, a}, a).distance, 0.0);
    const glm::dvec3 b(1, 2, 7);
    for (const Triangle &segment : {Triangle{a, a, b}, Triangle{a, b, a}, Triangle{b, a, a}, Triangle{a, b, b}}) {
        QCOMPARE(distanceTo(segment, {4, 2, 5}).distance, 3.0);
        QCOMPARE(distanceTo(segment, {1, 2, 8}).distance, 1.0);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestTriangleDistance)

#include "testtriangledistance.moc"
