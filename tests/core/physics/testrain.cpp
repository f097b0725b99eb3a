// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/rain.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/testmain.h"

namespace romanesco::test {

class TestRain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void ballsHaveRoom_data();
    void ballsHaveRoom();
    void chanceIsTheSeeds();
};

void TestRain::ballsHaveRoom_data()
{
    QTest::addColumn<Box>("box");
    QTest::addColumn<glm::dvec3>("gravity");
    QTest::addColumn<double>("radius");
    QTest::addColumn<std::size_t>("count");
    const Box unit{{-1, -2, -3}, {1, 2, 3}};
    const glm::dvec3 down(0, -9.8, 0);
    QTest::newRow("one") << unit << down << 0.1 << std::size_t{1};
    QTest::newRow("some") << unit << down << 0.05 << std::size_t{500};
    QTest::newRow("layers") << unit << down << 0.3 << std::size_t{200};
    QTest::newRow("larger than the box") << unit << down << 10.0 << std::size_t{20};
    QTest::newRow("tiny") << unit << down << 1e-9 << std::size_t{300};
    QTest::newRow("aslant") << unit << glm::dvec3(1, 2, -0.5) << 0.1 << std::size_t{300};
    QTest::newRow("no gravity") << unit << glm::dvec3(0.0) << 0.1 << std::size_t{100};
    QTest::newRow("a flat scene") << Box{{0, 0, 0}, {1, 0, 1}} << down << 0.02 << std::size_t{100};
    QTest::newRow("a point") << Box{} << down << 1.0 << std::size_t{5};
}

void TestRain::ballsHaveRoom()
{
    QFETCH(const Box, box);
    QFETCH(const glm::dvec3, gravity);
    QFETCH(const double, radius);
    QFETCH(const std::size_t, count);
    Ball like;
    like.radius = radius;
    like.restitution = 0.25;
    const std::vector<Ball> balls = rainOver(box, gravity, like, count, 1);
    QCOMPARE(balls.size(), count);
    const glm::dvec3 up = gravity == glm::dvec3(0.0) ? glm::dvec3(0, 1, 0) : -glm::normalize(gravity);
    for (std::size_t i = 0; i < count; ++i) {
        QCOMPARE(balls[i].radius, radius);
        QCOMPARE(balls[i].restitution, 0.25);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at{corner & 1 ? box.least.x : box.greatest.x, corner & 2 ? box.least.y : box.greatest.y,
                                corner & 4 ? box.least.z : box.greatest.z};
            QVERIFY(glm::dot(balls[i].position - at, up) > 1.5 * radius);
        }
        for (std::size_t j = 0; j < i; ++j) {
            QVERIFY(glm::distance(balls[i].position, balls[j].position) > 2.05 * radius);
        }
    }
}

void TestRain::chanceIsTheSeeds()
{
    const Box box{{-1, -1, -1}, {1, 1, 1}};
    Ball like;
    like.radius = 0.1;
    const auto placeOf = [&](std::uint64_t seed) {
        return rainOver(box, {0.0, -1.0, 0.0}, like, 10, seed).back().position;
    };
    QVERIFY(placeOf(3) == placeOf(3));
    QVERIFY(placeOf(3) != placeOf(4));
}

}

ROMANESCO_TEST(romanesco::test::TestRain)

#include "testrain.moc"
