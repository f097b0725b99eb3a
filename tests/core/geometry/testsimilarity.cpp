// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/geometry/similarity.h"

#include <cmath>
#include <random>

#include <QTest>
#include <glm/geometric.hpp>

#include "tests/core/fractal/randomfractals.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestSimilarity : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void turnedScaledAndMirroredKeepsAngles();
    void allElseIsNone();
};

void TestSimilarity::turnedScaledAndMirroredKeepsAngles()
{
    std::mt19937_64 random(seed(61));
    const auto number = [&] { return uniform(random, -180, 180); };
    for (int round = 0; round < 2'000; ++round) {
        const double size = std::pow(10.0, uniform(random, -100, 100));
        const AffineMap map = mapFromParts(size * glm::dvec3(number(), number(), number()),
                                           {number(), number(), number()}, {round % 2 == 0 ? size : -size, size, size});
        const auto found = similarityOf(map);
        QVERIFY(found && found->map == map);
        QVERIFY(std::abs(found->scale / size - 1) < 1e-15);
        const glm::dvec3 point = size * glm::dvec3(number(), number(), number());
        QVERIFY(glm::distance(map(found->inverse(point)) / size, point / size) < 1e-12);
    }
}

void TestSimilarity::allElseIsNone()
{
    AffineMap sheared = mapFromParts({}, {10, 20, 30}, {2, 2, 2});
    sheared.linear[1] += 1e-13 * sheared.linear[0];
    QVERIFY(!similarityOf(sheared));
    QVERIFY(!similarityOf(mapFromParts({}, {10, 20, 30}, {2, 2, 2 + 1e-13})));
    QVERIFY(!similarityOf(mapFromParts({}, {10, 20, 30}, {1, 1, 0})));
    QVERIFY(!similarityOf(mapFromParts({}, {10, 20, 30}, {0, 0, 0})));
    QVERIFY(!similarityOf(mapFromParts({1e300, 0, 0}, {}, glm::dvec3(1e-100))));
}

}

ROMANESCO_TEST(romanesco::test::TestSimilarity)

#include "testsimilarity.moc"
