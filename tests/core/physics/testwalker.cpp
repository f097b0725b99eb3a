// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/walker.h"

#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double tick = 1.0 / 60.0;
const glm::dvec3 none(0.0);
const glm::dvec3 down(0.0, -9.8, 0.0);

}

class TestWalker : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inTheOpenItGoesAllTheWay();
    void itEntersNothing();
    void itSlidesAlongAWall();
    void itFallsAndStands();
    void itWalksOverTheFloor();
    void itWalksOffAnEdge();
};

void TestWalker::inTheOpenItGoesAllTheWay()
{
    Ground ground(boxMesh(1));
    Walker walker(ground.surface, {5, 0, 0}, 0.1);
    walker.go({1, 2, 3}, tick, none);
    QVERIFY(glm::distance(walker.position(), {6, 2, 3}) < 1e-12);
    walker.go(none, tick, none);
    QVERIFY(glm::distance(walker.position(), {6, 2, 3}) < 1e-12);
}

/// However it goes about in a fractal, in long ways and in short ones.
void TestWalker::itEntersNothing()
{
    Ground ground(QStringLiteral("menger"), 4);
    std::mt19937_64 random(seed(5));
    const double radius = 0.02;
    for (int trial = 0; trial < 40; ++trial) {
        glm::dvec3 at = randomPoint(random, 1.4);
        while (ground.distance(at) < radius) {
            at = randomPoint(random, 1.4);
        }
        Walker walker(ground.surface, at, radius);
        for (int i = 0; i < 100; ++i) {
            const glm::dvec3 before = walker.position();
            walker.go(randomPoint(random, std::pow(10.0, uniform(random, -4.0, 1.0))), tick, trial % 2 ? down : none);
            QVERIFY(ground.distance(walker.position()) >= radius * (1.0 - 1e-3));
            // nor does it jump through: it stays in the open, which is all one, or outside
            QVERIFY(glm::distance(walker.position(), before) < 100.0);
        }
    }
}

/// Against a wall aslant: what is along the wall is left of the way.
void TestWalker::itSlidesAlongAWall()
{
    Ground ground(boxMesh(1));
    Walker walker(ground.surface, {2, 0, 0}, 0.25);
    walker.go({-1.75, 0.5, 0.25}, tick, none);
    QVERIFY(std::abs(walker.position().x - 1.25) < 1e-4 * 0.25);
    QVERIFY(std::abs(walker.position().y - 0.5) < 1e-6);
    QVERIFY(std::abs(walker.position().z - 0.25) < 1e-6);
    // straight away again
    walker.go({1, 0, 0}, tick, none);
    QVERIFY(walker.position().x > 2.2);
}

void TestWalker::itFallsAndStands()
{
    Ground ground(boxMesh(1));
    Walker walker(ground.surface, {0, 2, 0}, 0.25);
    double last = 2.0;
    int ticks = 0;
    while (!walker.isCarried() && ticks < 1000) {
        walker.go(none, tick, down);
        QVERIFY(walker.position().y <= last);
        last = walker.position().y;
        ++ticks;
    }
    // 0.75 deep: sqrt(2 h / g)
    QVERIFY(std::abs(ticks * tick - std::sqrt(1.5 / 9.8)) < 2.0 * tick);
    QVERIFY(std::abs(walker.position().y - 1.25) < 1e-4 * 0.25);
    const glm::dvec3 there = walker.position();
    for (int i = 0; i < 100; ++i) {
        walker.go(none, tick, down);
    }
    QVERIFY(walker.position() == there);
    // looking down does not drive it in, nor is it slower for that, nor does it fall faster
    Walker above(ground.surface, {0, 4, 0}, 0.25);
    above.go({0.0, -1.0, 0.0}, tick, down);
    QVERIFY(above.position().y > 3.99);
    walker.go({0.3, -5.0, 0.0}, tick, down);
    QVERIFY(std::abs(walker.position().x - there.x - 0.3) < 1e-6);
}

void TestWalker::itWalksOverTheFloor()
{
    Ground ground(boxMesh(1));
    Walker walker(ground.surface, {-0.9, 1.3, 0}, 0.25);
    for (int i = 0; i < 90; ++i) {
        walker.go({0.02, 0, 0}, tick, down);
    }
    QVERIFY(walker.isCarried());
    QVERIFY(std::abs(walker.position().x - 0.9) < 1e-3);
    QVERIFY(std::abs(walker.position().y - 1.25) < 1e-4 * 0.25);
}

void TestWalker::itWalksOffAnEdge()
{
    Ground ground(boxMesh(1));
    Walker walker(ground.surface, {0.8, 1.25, 0}, 0.25);
    for (int i = 0; i < 60; ++i) {
        walker.go({0.02, 0, 0}, tick, down);
    }
    QVERIFY(!walker.isCarried());
    QVERIFY(walker.position().y < 0.0);
}

}

ROMANESCO_TEST(romanesco::test::TestWalker)

#include "testwalker.moc"
