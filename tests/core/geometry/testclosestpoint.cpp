// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/closestpoint.h"

#include <algorithm>

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/geometry/triangles.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// What is promised of an answer. The point itself is rounded to doubles where p is.
void requireClosest(const Triangle &triangle, const glm::dvec3 &p)
{
    const ClosestPoint answer = closestPoint(triangle, p);
    const Real least = trueDistance(triangle, p);
    const Real unit = Real(std::ldexp(largestOffset(triangle, p), -53));
    RC_ASSERT(Real(answer.lower) <= least);
    RC_ASSERT(Real(answer.distance) - Real(answer.lower) <= 32 * unit);
    RC_ASSERT(Real(answer.distance) >= least - 8 * unit);
    const Real ulp = Real(std::ldexp(std::max(glm::length(answer.point), 1e-300), -52));
    RC_ASSERT(trueDistance(triangle, answer.point) <= 8 * unit + ulp);
    RC_ASSERT(abs(distance(exact(p), exact(answer.point)) - Real(answer.distance)) <= 8 * unit + ulp);
}

}

class TestClosestPoint : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void trianglesOfAnyShapeHaveACertifiedAnswer_data();
    void trianglesOfAnyShapeHaveACertifiedAnswer();
    void hardTrianglesAreSolvedAgain();
    void verticesMayStandInAnyOrder();
    void sizesMayBeExtreme();
    void normalsMayUnderflow();
    void pointsOfTheTriangleAreAtNoDistance();
};

void TestClosestPoint::trianglesOfAnyShapeHaveACertifiedAnswer_data()
{
    addShapes();
}

void TestClosestPoint::trianglesOfAnyShapeHaveACertifiedAnswer()
{
    QFETCH(Shape, shape);
    QVERIFY(rc::check([shape](std::uint32_t seed) {
        Draw draw(seed);
        const auto [triangle, p] = trianglePoint(shape, draw);
        requireClosest(triangle, p);
    }));
}

void TestClosestPoint::hardTrianglesAreSolvedAgain()
{
    // about one in 25,000 of these is beyond what double can certify
    Draw draw(1);
    for (int i = 0; i < 300'000; ++i) {
        Triangle triangle{draw.vector(), draw.vector(), draw.vector()};
        const glm::dvec3 along = triangle[1] - triangle[0];
        triangle[2] = triangle[0] + draw.number(-1.0, 2.0) * along + draw.vector(1e-3);
        const glm::dvec3 p = triangle[0] + draw.number(-1.0, 1.0) * along + draw.vector(1e-3);
        const ClosestPoint answer = closestPoint(triangle, p);
        QVERIFY(answer.distance - answer.lower <= 32 * std::ldexp(largestOffset(triangle, p), -53));
    }
}

void TestClosestPoint::verticesMayStandInAnyOrder()
{
    QVERIFY(rc::check([](std::uint32_t seed) {
        Draw draw(seed);
        const Triangle triangle{draw.vector(), draw.vector(), draw.vector()};
        const glm::dvec3 p = draw.vector(2.0);
        const double expected = closestPoint(triangle, p).distance;
        std::array order{0, 1, 2};
        do {
            const auto at = [&](int i) {
                return triangle[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])];
            };
            RC_ASSERT(std::abs(closestPoint({at(0), at(1), at(2)}, p).distance - expected) <= 1e-14);
        } while (std::ranges::next_permutation(order).found);
    }));
}

void TestClosestPoint::sizesMayBeExtreme()
{
    QVERIFY(rc::check([] {
        // nine powers of ten apart at most, so that 100 digits are enough for the truth
        const int least = *rc::gen::inRange(-290, 290);
        const auto vector = [least] { return *wildVector(least, least + 9); };
        const Triangle triangle{vector(), vector(), vector()};
        requireClosest(triangle, vector());
    }));
    for (const double size : {1e-300, 1e-160, 1e-30, 1e30, 1e160, 1e300}) {
        const Triangle triangle{glm::dvec3(size, 0, 0), glm::dvec3(0, size, 0), glm::dvec3(0, 0, size)};
        const ClosestPoint answer = closestPoint(triangle, glm::dvec3(0.0));
        QVERIFY(std::abs(answer.distance / size - 1.0 / std::sqrt(3.0)) <= 1e-15);
        QVERIFY(glm::length(answer.point / size - glm::dvec3(1.0 / 3.0)) <= 1e-15);
    }
}

void TestClosestPoint::normalsMayUnderflow()
{
    for (double size = 1e-70; size > 1e-90; size *= 0.9) {
        const Triangle triangle{glm::dvec3(1, size, 0), glm::dvec3(1, 0, size), glm::dvec3(1, -size, -size)};
        const ClosestPoint answer = closestPoint(triangle, glm::dvec3(0.0));
        QVERIFY(answer.lower <= 1.0);
        QVERIFY(answer.distance >= 1.0 && answer.distance - answer.lower <= 32 * 0x1p-53);
    }
}

void TestClosestPoint::pointsOfTheTriangleAreAtNoDistance()
{
    const Triangle triangle{glm::dvec3(0, 0, 0), glm::dvec3(4, 0, 0), glm::dvec3(0, 4, 0)};
    for (const glm::dvec3 &p : {triangle[0], triangle[1], triangle[2], glm::dvec3(2, 0, 0), glm::dvec3(2, 2, 0),
                                glm::dvec3(0, 1, 0), glm::dvec3(1, 1, 0), glm::dvec3(0.1, 0.3, 0)}) {
        const ClosestPoint answer = closestPoint(triangle, p);
        QVERIFY(answer.distance <= 1e-15);
        QCOMPARE(answer.lower, 0.0);
        QVERIFY(glm::distance(answer.point, p) <= 1e-15);
    }
    const ClosestPoint above = closestPoint(triangle, {1, 1, 0.25});
    QCOMPARE(above.point, glm::dvec3(1, 1, 0));
    QCOMPARE(above.distance, 0.25);
}

}

ROMANESCO_TEST(romanesco::test::TestClosestPoint)

#include "testclosestpoint.moc"
