// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

constexpr double g = 9.8;

/// What a ball that is dropped on a floor does, by the closed form: its height above where it lies, its speed upwards.
struct Bounced {
    double height;
    double speed;
    int bounces;
};
Bounced bouncedAfter(double time, double from, double restitution)
{
    double fall = std::sqrt(2 * from / g);
    if (time < fall) {
        return {from - 0.5 * g * time * time, -g * time, 0};
    }
    time -= fall;
    double speed = restitution * g * fall;
    for (int bounces = 1;; ++bounces) {
        const double flight = 2 * speed / g;
        if (time < flight || bounces > 10'000) {
            return {speed * time - 0.5 * g * time * time, speed - g * time, bounces};
        }
        time -= flight;
        speed *= restitution;
    }
}

}

class TestFlight : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void inTheAirItIsTheParabola_data();
    void inTheAirItIsTheParabola();
    void bouncesAreThoseOfTheClosedForm_data();
    void bouncesAreThoseOfTheClosedForm();
    void aSlopeReflects();
    void stepsOfAnyLengthComeToTheSame();
    void aBouncingBallKeepsItsEnergy();
    void aCeilingIsTouchedOnTheWayUp();
    void aLongFlightIsSweptAtOnce();
    void nothingIsAskedWhereNothingIsNear();
    void oneSteppedByOneStaysInsideABox();
};

void TestFlight::inTheAirItIsTheParabola_data()
{
    QTest::addColumn<glm::dvec3>("gravity");
    QTest::newRow("downwards") << glm::dvec3(0, -9.8, 0);
    QTest::newRow("nowhere") << glm::dvec3(0);
    QTest::newRow("sideways") << glm::dvec3(3, 0, -1e-3);
}

void TestFlight::inTheAirItIsTheParabola()
{
    QFETCH(const glm::dvec3, gravity);
    Ground ground(floorMesh(1));
    Laws laws;
    laws.gravity = gravity;
    const glm::dvec3 start(0.1, 100, 0.2);
    const glm::dvec3 velocity(1, 2, -3);
    BallState ball = ballAt(start, 0.05, 0.5, velocity);
    for (int step = 1; step <= 240; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
        const double t = step * laws.timeStep;
        QVERIFY(glm::distance(ball.position, start + t * velocity + 0.5 * t * t * gravity) < 1e-11);
        QVERIFY(glm::distance(ball.velocity, velocity + t * gravity) < 1e-12);
    }
}

void TestFlight::bouncesAreThoseOfTheClosedForm_data()
{
    QTest::addColumn<double>("restitution");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("seconds");
    for (const double radius : {0.3, 0.01, 1e-4, 1e-6}) {
        QTest::addRow("e = 1, r = %g", radius) << 1.0 << radius << 8.0;
        QTest::addRow("e = 0.8, r = %g", radius) << 0.8 << radius << 3.0;
        QTest::addRow("e = 0.5, r = %g", radius) << 0.5 << radius << 1.2;
    }
}

/// It bounces up to a ten-thousandth of its radius too high.
void TestFlight::bouncesAreThoseOfTheClosedForm()
{
    QFETCH(const double, restitution);
    QFETCH(const double, radius);
    QFETCH(const double, seconds);
    Ground ground(floorMesh(2));
    const Laws laws;
    const double from = 1.0;
    BallState ball = ballAt({0.2, from + radius, 0.1}, radius, restitution);
    for (int step = 1; step * laws.timeStep < seconds; ++step) {
        const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
        const Bounced truth = bouncedAfter(step * laws.timeStep, from, restitution);
        // each bounce that is too high by the skin comes too early
        const double late = (truth.bounces + 1) * 2e-4 * radius / std::max(0.3, std::abs(truth.speed)) + 1e-12;
        const double height = ball.position.y - radius;
        QVERIFY2(std::abs(height - truth.height) <= 1.1e-4 * radius + 4.5 * late * 3,
                 qPrintable(QStringLiteral("step %1: %2, not %3").arg(step).arg(height).arg(truth.height)));
        QVERIFY(!report.isExhausted);
        QVERIFY(height > 0);
    }
    const Bounced truth = bouncedAfter(seconds, from, restitution);
    QVERIFY(truth.bounces >= 2);
}

/// Off a plane at any angle, at any speed: the ball leaves as light would, slower by e across the plane.
void TestFlight::aSlopeReflects()
{
    std::mt19937_64 random(seed(4));
    for (int round = 0; round < 300; ++round) {
        const AffineMap place = mapFromParts({}, randomPoint(random, 180), {1, 1, 1});
        Ground ground(floorMesh(100), place);
        const glm::dvec3 n = place.linear * glm::dvec3(0, 1, 0);
        Laws laws;
        laws.gravity = glm::dvec3(0);
        const double radius = std::pow(10.0, uniform(random, -4, 0));
        const double e = uniform(random, 0, 1);
        glm::dvec3 v = glm::normalize(randomPoint(random, 1.0));
        v = v - (glm::dot(v, n) + uniform(random, 0.05, 1)) * n;
        v *= std::pow(10.0, uniform(random, -1, 4));
        const double against = -glm::dot(v, n);
        const double height = uniform(random, 0.1, 0.9) * against * laws.timeStep;
        BallState ball = ballAt((radius + height) * n, radius, e, v);
        stepBall(ball, laws, ground.probe, laws.timeStep);
        const glm::dvec3 expected = v + (1 + e) * against * n;
        QVERIFY2(glm::distance(ball.velocity, expected) < 1e-8 * glm::length(v), qPrintable(QString::number(round)));
        const double rest = laws.timeStep - height / against;
        const glm::dvec3 place2 = (radius + height) * n + (laws.timeStep - rest) * v + rest * expected;
        QVERIFY(glm::distance(ball.position, place2) < 3e-4 * radius * (1 + glm::length(v) / against) + 1e-8);
    }
}

/// Of a bounce that nothing comes near to being left out.
void TestFlight::stepsOfAnyLengthComeToTheSame()
{
    Ground ground(boxMesh(1), mapFromParts({}, {10, 20, 30}, {1, 1, 1}));
    BallState last;
    for (const int steps : {1, 7, 60, 1000}) {
        Laws laws;
        laws.timeStep = 0.3 / steps;
        BallState ball = ballAt({0.1, -0.2, 0.3}, 0.001, 1, {4, 6, 5});
        for (int i = 0; i < steps; ++i) {
            QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
        }
        // too high by the skin at each of three walls, or less
        QVERIFY2(steps == 1 || glm::distance(ball.position, last.position) < 2e-6,
                 qPrintable(QString::number(glm::distance(ball.position, last.position))));
        last = ball;
    }
}

void TestFlight::aBouncingBallKeepsItsEnergy()
{
    for (const double radius : {0.1, 1e-3}) {
        Ground ground(floorMesh(2));
        const Laws laws;
        BallState ball = ballAt({0.2, 0.01 + radius, 0.1}, radius, 1);
        const double energy = energyOf(ball, laws) + laws.gravity.y * radius;
        unsigned bounces = 0;
        for (int step = 0; step < 120'000; ++step) {
            bounces += stepBall(ball, laws, ground.probe, laws.timeStep).contacts;
        }
        QVERIFY2(bounces > 5000, qPrintable(QString::number(bounces)));
        const double now = energyOf(ball, laws) + laws.gravity.y * radius;
        QVERIFY2(std::abs(now / energy - 1) < 1e-6, qPrintable(QString::number(now / energy - 1)));
    }
}

/// Also by a ball that is back below its start at the end of the step.
void TestFlight::aCeilingIsTouchedOnTheWayUp()
{
    Ground ground(floorMesh(1));
    Laws laws;
    laws.timeStep = 0.1;
    const double speed = 0.45;
    const double room = 0.006;
    BallState ball = ballAt({0, -0.1 - room, 0}, 0.1, 1, {0, speed, 0});
    const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
    QCOMPARE(report.contacts, 1u);
    const double fast = std::sqrt(speed * speed - 2 * g * room);
    const double rise = (speed - fast) / g;
    const double fall = laws.timeStep - rise;
    QVERIFY(std::abs(ball.velocity.y + fast + g * fall) < 1e-3);
    QVERIFY(std::abs(ball.position.y + 0.1 + fast * fall + 0.5 * g * fall * fall) < 1e-4);
}

/// From a bounce to what it comes to next, with a ball whose way is much longer than itself: and no question is asked between.
void TestFlight::aLongFlightIsSweptAtOnce()
{
    Ground ground(floorMesh(100));
    Laws laws;
    laws.gravity = glm::dvec3(0);
    BallState ball = ballAt({0, 1, 0}, 0.001, 1, {2.4, -0.24, 0});
    ball.position.y = 0.01;
    unsigned queries = 0;
    unsigned contacts = 0;
    for (int step = 0; step < 22; ++step) {
        const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
        queries += report.queries;
        contacts += report.contacts;
        QVERIFY(ball.position.y >= 0.001 * (1 - 1e-9));
    }
    QCOMPARE(contacts, 1u);
    QVERIFY2(queries <= 9, qPrintable(QString::number(queries)));
    // another velocity is another flight
    ball.velocity = {0, -24, 0};
    ball.clearance = 0;
    const double height = ball.position.y;
    stepBall(ball, laws, ground.probe, laws.timeStep);
    QVERIFY(std::abs(ball.position.y - (24 * laws.timeStep - (height - 0.001) + 0.001)) < 1e-6);
}

void TestFlight::nothingIsAskedWhereNothingIsNear()
{
    Ground ground(floorMesh(1));
    const Laws laws;
    BallState ball = ballAt({0, 10, 0}, 0.1);
    unsigned queries = 0;
    for (int step = 0; step < 240; ++step) {
        queries += stepBall(ball, laws, ground.probe, laws.timeStep).queries;
    }
    QVERIFY2(queries < 40, qPrintable(QString::number(queries)));
}

/// Of thin walls, however far it would go in a step.
void TestFlight::oneSteppedByOneStaysInsideABox()
{
    std::mt19937_64 random(seed(5));
    Ground ground(boxMesh(1), mapFromParts({}, {10, 20, 30}, {1, 1, 1}));
    const glm::dmat3 back = glm::transpose(mapFromParts({}, {10, 20, 30}, {1, 1, 1}).linear);
    for (int round = 0; round < 200; ++round) {
        Laws laws;
        laws.gravity = randomPoint(random, 20);
        const double radius = std::pow(10.0, uniform(random, -4, -1));
        const double way = std::pow(10.0, uniform(random, -1, 4)) * radius;
        BallState ball = ballAt(randomPoint(random, 0.5), radius, uniform(random, 0, 1),
                                way / laws.timeStep * glm::normalize(randomPoint(random, 1)));
        for (int step = 0; step < 50; ++step) {
            stepBall(ball, laws, ground.probe, laws.timeStep);
            const glm::dvec3 inBox = glm::abs(back * ball.position);
            const double farthest = std::max({inBox.x, inBox.y, inBox.z});
            QVERIFY2(farthest <= 1 - radius * (1 - 1e-9),
                     qPrintable(QStringLiteral("round %1, step %2: %3").arg(round).arg(step).arg(farthest)));
        }
    }
}

}

ROMANESCO_TEST(romanesco::test::TestFlight)

#include "testflight.moc"
