// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/collide/meshes.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestSliding : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anEdgeHoldsNothingBack();
    void onASlopeItIsTheClosedForm_data();
    void onASlopeItIsTheClosedForm();
    void coplanarFacesAndCopiesDoNotBump_data();
    void coplanarFacesAndCopiesDoNotBump();
    void anEdgeAheadDoesNotBump_data();
    void anEdgeAheadDoesNotBump();
    void aWallIsSlidAlong();
    void alongAGrooveItIsTheClosedForm();
    void aMotionThatIsRoundingDoesNotTurn();
    void anEdgeLetsItFall();
    void roundABowlEnergyIsKept();
    void fastBallsSlideInFewQueries();
};

/// Where a ball stands right over an edge it touches in two directions that hardly differ.
void TestSliding::anEdgeHoldsNothingBack()
{
    Ground ground(boxMesh(1));
    for (const double before : {1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 1e-6, 1e-7, 1e-9, 0.0, -1e-6, -1e-3}) {
        for (const double restitution : {0.0, 0.5}) {
            for (const double timeStep : {1.0 / 60.0, 1.0 / 240.0}) {
                BallState ball;
                ball.position = {1.0 - before, 1.250011, 0.0};
                ball.radius = 0.25;
                ball.restitution = restitution;
                ball.velocity = {1.2, 0.0, 0.0};
                Laws laws;
                laws.timeStep = timeStep;
                const StepReport report = stepBall(ball, laws, ground.probe, timeStep);
                QVERIFY(!report.isExhausted);
                QVERIFY2(ball.velocity.x > 1.19, qPrintable(QString::number(before)));
                QVERIFY(ball.position.x > 1.0 - before + 0.99 * 1.2 * timeStep);
            }
        }
    }
}

void TestSliding::onASlopeItIsTheClosedForm_data()
{
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("radius");
    for (const double degrees : {1.0, 30.0, 60.0, 85.0}) {
        for (const double radius : {0.1, 1e-3, 1e-4}) {
            QTest::addRow("%g degrees, r = %g, e = 0.5", degrees, radius) << degrees << 0.5 << radius;
            QTest::addRow("%g degrees, r = %g, e = 1", degrees, radius) << degrees << 1.0 << radius;
        }
    }
}

/// From rest, and with a start across the slope.
void TestSliding::onASlopeItIsTheClosedForm()
{
    QFETCH(const double, degrees);
    QFETCH(const double, restitution);
    QFETCH(const double, radius);
    const AffineMap place = mapFromParts({}, {0, 0, degrees}, {1, 1, 1});
    Ground ground(floorMesh(100), place);
    const glm::dvec3 n = place.linear * glm::dvec3(0, 1, 0);
    const Laws laws;
    const glm::dvec3 pull = laws.gravity - glm::dot(laws.gravity, n) * n;
    for (const glm::dvec3 &velocity : {glm::dvec3(0), glm::dvec3(0, 0, 0.7)}) {
        const glm::dvec3 start = radius * (1 + 5e-5) * n;
        BallState ball = ballAt(start, radius, restitution, velocity);
        for (int step = 1; step <= 240; ++step) {
            const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
            const double t = step * laws.timeStep;
            const glm::dvec3 truth = start + t * velocity + 0.5 * t * t * pull;
            QVERIFY2(glm::distance(ball.position, truth) < 1e-9 + 1e-4 * radius,
                     qPrintable(QStringLiteral("step %1: %2").arg(step).arg(glm::distance(ball.position, truth))));
            QVERIFY(glm::distance(ball.velocity, velocity + t * pull) < 1e-7);
            QVERIFY(std::abs(glm::dot(ball.position, n) - radius) <= 1e-4 * radius);
            QVERIFY(!report.isExhausted && report.contacts > 0);
        }
    }
}

void TestSliding::coplanarFacesAndCopiesDoNotBump_data()
{
    QTest::addColumn<double>("degrees");
    QTest::newRow("level") << 0.0;
    QTest::newRow("turned") << 21.0;
}

/// Neither the faces of a plate nor copies of it side by side are felt, where the ball is far larger or smaller than they are.
void TestSliding::coplanarFacesAndCopiesDoNotBump()
{
    QFETCH(const double, degrees);
    std::mt19937_64 random(seed(6));
    const AffineMap place = mapFromParts({1, 2, 3}, {0, 0, degrees}, {1, 1, 1});
    std::vector<SceneItem> items;
    const auto model = modelOf(plate(8));
    for (int i = -2; i < 2; ++i) {
        for (int k = -2; k < 2; ++k) {
            items.push_back({.model = model, .worldFromModel = place * AffineMap{glm::dmat3(1.0), {8 * i, 0, 8 * k}}});
        }
    }
    Ground ground(items);
    const glm::dvec3 n = place.linear * glm::dvec3(0, 1, 0);
    Laws laws;
    laws.gravity = -9.8 * n;
    for (const double radius : {3.0, 0.1, 1e-3}) {
        for (int round = 0; round < 10; ++round) {
            const double angle = uniform(random, 0, 6.28);
            const glm::dvec3 v = place.linear * glm::dvec3(5 * std::cos(angle), 0, 5 * std::sin(angle));
            const glm::dvec3 start = place({uniform(random, -2, 2), radius * (1 + 5e-5), uniform(random, -2, 2)});
            BallState ball = ballAt(start, radius, 0.9, v);
            for (int step = 1; step <= 300; ++step) {
                stepBall(ball, laws, ground.probe, laws.timeStep);
                QVERIFY(glm::distance(ball.velocity, v) < 1e-8);
                QVERIFY(glm::distance(ball.position, start + step * laws.timeStep * v) < 1e-8);
            }
        }
    }
}

void TestSliding::anEdgeAheadDoesNotBump_data()
{
    QTest::addColumn<double>("ahead");
    for (const double ahead : {0.05, 0.025, 0.01, 1e-3, 1e-5}) {
        QTest::addRow("%g", ahead) << ahead;
    }
}

/// What is within the skin is touched, and an edge within a plane may be: whether the ball is put down before it or falls there.
void TestSliding::anEdgeAheadDoesNotBump()
{
    QFETCH(const double, ahead);
    Ground ground(plate(8));
    const Laws laws;
    for (const double radius : {3.0, 0.3}) {
        const glm::dvec3 start{4 - ahead * radius / 3, radius * (1 + 5e-5), 3.5};
        BallState lying = ballAt(start, radius, 0.9, {5, 0, 0});
        stepBall(lying, laws, ground.probe, laws.timeStep);
        QVERIFY(glm::distance(lying.velocity, glm::dvec3(5, 0, 0)) < 1e-8);
        // every bounce is less than what the edge would give
        BallState falling = ballAt(start, radius, 0.2, {5, -0.03, 0});
        for (int step = 1; step <= 5; ++step) {
            stepBall(falling, laws, ground.probe, laws.timeStep);
            QVERIFY2(std::abs(falling.velocity.x - 5) < 1e-8, qPrintable(QString::number(falling.velocity.x - 5)));
            QVERIFY(falling.velocity.y <= 0.2 * (0.03 + step * laws.timeStep * 9.8));
        }
    }
}

/// A ball that falls beside a wall that it touches.
void TestSliding::aWallIsSlidAlong()
{
    Ground ground(floorMesh(100), mapFromParts({}, {0, 0, 90}, {1, 1, 1}));
    const Laws laws;
    for (const double side : {-1.0, 1.0}) {
        const glm::dvec3 start(side * 0.1 * (1 + 5e-5), 20, 0);
        BallState ball = ballAt(start, 0.1, 0.7, {0, 0, 2});
        unsigned queries = 0;
        for (int step = 1; step <= 240; ++step) {
            queries += stepBall(ball, laws, ground.probe, laws.timeStep).queries;
            const double t = step * laws.timeStep;
            QVERIFY(glm::distance(ball.position, start + glm::dvec3(0, -4.9 * t * t, 2 * t)) < 1e-9);
        }
        QVERIFY2(queries < 240 * 12, qPrintable(QString::number(queries)));
    }
}

/// That goes down at an angle, on both of its sides.
void TestSliding::alongAGrooveItIsTheClosedForm()
{
    const AffineMap place = mapFromParts({}, {20, 0, 0}, {1, 1, 1});
    for (const double slope : {0.3, 1.0, 3.0}) {
        Ground ground(grooveMesh(50, slope), place);
        const Laws laws;
        const glm::dvec3 along = place.linear * glm::dvec3(0, 0, 1);
        const glm::dvec3 pull = glm::dot(laws.gravity, along) * along;
        const double radius = 0.1;
        BallState ball =
            ballAt(place({0, radius * (1 + 5e-5) * std::sqrt(1 + slope * slope), 0}), radius, 0.5, 0.3 * along);
        const glm::dvec3 start = ball.position;
        for (int step = 1; step <= 400; ++step) {
            QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
            const double t = step * laws.timeStep;
            const double off = glm::distance(ball.position, start + 0.3 * t * along + 0.5 * t * t * pull);
            QVERIFY2(off < 2e-4 * radius, qPrintable(QStringLiteral("step %1: %2").arg(step).arg(off)));
        }
        QVERIFY(ball.supports.count() == 2);
    }
}

/// What goes across the pull but for its last digits would turn again and again, and no time would go by.
void TestSliding::aMotionThatIsRoundingDoesNotTurn()
{
    std::mt19937_64 random(seed(40));
    for (int i = 0; i < 1'000; ++i) {
        const glm::dvec3 pull = 9.8 * randomPoint(random, 1.0);
        glm::dvec3 v = std::pow(10.0, uniform(random, -30, -16)) * glm::cross(randomPoint(random, 1.0), pull);
        double left = 1.0 / 240.0;
        int turns = 0;
        for (; left > 0.0 && turns < 10; ++turns) {
            const double time = timeForward(v, pull, left);
            v += time * pull;
            left -= time;
        }
        QVERIFY2(left <= 0.0, qPrintable(QString::number(left)));
        QVERIFY(turns <= 3);
    }
}

/// From a table at one speed: it falls as the parabola says, but for a step at the edge.
void TestSliding::anEdgeLetsItFall()
{
    Ground ground(floorMesh(1));
    const Laws laws;
    const double radius = 0.01;
    BallState ball = ballAt({0, radius * (1 + 5e-5), 0}, radius, 0.3, {2, 0, 0});
    for (int step = 1; step <= 240; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    const double t = 0.5; // after the edge
    QVERIFY(std::abs(ball.position.x - 2) < 1e-6);
    QVERIFY2(std::abs(ball.position.y - (radius - 4.9 * t * t)) < 9.8 * t * 1.5 * laws.timeStep,
             qPrintable(QString::number(ball.position.y)));
}

/// Of many faces, that meet at small angles: each costs a little of the speed across it, none is won.
void TestSliding::roundABowlEnergyIsKept()
{
    Ground ground(ball(80), mapFromParts({}, {}, {2, 2, 2}));
    const Laws laws;
    BallState moving = ballAt({0.6, -1.5, 0}, 0.05, 0.2);
    double energy = energyOf(moving, laws);
    for (int step = 0; step < 480; ++step) {
        stepBall(moving, laws, ground.probe, laws.timeStep);
        const double now = energyOf(moving, laws);
        QVERIFY(now <= energy + 1e-3 * 9.8 * moving.radius);
        energy = now;
        QVERIFY(glm::length(moving.position) < 2);
    }
    QVERIFY(moving.supports.count() > 0 || glm::length(moving.velocity) > 0.01);
}

void TestSliding::fastBallsSlideInFewQueries()
{
    Ground ground(floorMesh(100));
    const Laws laws;
    const double radius = 1e-4;
    const glm::dvec3 v(1000 * radius / laws.timeStep, 0, 0);
    BallState ball = ballAt({-50, radius * (1 + 5e-5), 0}, radius, 0.5, v);
    for (int step = 1; step <= 100; ++step) {
        const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
        QVERIFY(report.queries <= 6);
        QVERIFY(glm::distance(ball.position, glm::dvec3(-50 + step * laws.timeStep * v.x, radius, 0)) < 1e-6);
    }
}

}

ROMANESCO_TEST(romanesco::test::TestSliding)

#include "testsliding.moc"
