// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestExtremes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aBallThatOverlapsLeavesOrStays_data();
    void aBallThatOverlapsLeavesOrStays();
    void aBallInANarrowGapStays();
    void radiiOfEverySize_data();
    void radiiOfEverySize();
    void stepsOfEveryLength_data();
    void stepsOfEveryLength();
    void restitutionsAtTheEnds();
    void nothingToFallOn();
    void farAwayAndForEver();
    void flatAndDegenerateFacesHold();
};

void TestExtremes::aBallThatOverlapsLeavesOrStays_data()
{
    QTest::addColumn<glm::dvec3>("start");
    QTest::newRow("near a face") << glm::dvec3(0.3, 1.05, 0.2);
    QTest::newRow("on a face") << glm::dvec3(0.3, 1, 0.2);
    QTest::newRow("on an edge") << glm::dvec3(1, 1, 0.2);
    QTest::newRow("on a corner") << glm::dvec3(1, 1, 1);
    QTest::newRow("inside, near a face") << glm::dvec3(0.3, 0.95, 0.2);
    QTest::newRow("inside, in a corner") << glm::dvec3(0.97, 0.96, 0.95);
    QTest::newRow("below a face") << glm::dvec3(0.3, -1.02, 0.2);
}

/// It stands free after a step, with no more energy than it had and its way out costs.
void TestExtremes::aBallThatOverlapsLeavesOrStays()
{
    QFETCH(const glm::dvec3, start);
    Ground ground(boxMesh(1));
    const Laws laws;
    for (const glm::dvec3 &velocity : {glm::dvec3(0), glm::dvec3(1, -2, 0.5)}) {
        for (const double e : {0.0, 0.5, 1.0}) {
            BallState ball = ballAt(start, 0.1, e, velocity);
            stepBall(ball, laws, ground.probe, laws.timeStep);
            QVERIFY(ground.distance(ball.position) >= 0.1 * (1 - 1e-9));
            QVERIFY(glm::distance(ball.position, start) < 0.1 * std::sqrt(3.0) + 0.02);
            QVERIFY(glm::length(ball.velocity) <= glm::length(velocity) + 9.8 * laws.timeStep);
            QVERIFY(energyOf(ball, laws) <= energyOf(ballAt(start, 0.1, e, velocity), laws) + 9.8 * 0.1001 + 1e-9);
            double energy = energyOf(ball, laws);
            for (int step = 0; step < 100; ++step) {
                QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
                QVERIFY(energyOf(ball, laws) <= energy + 1e-3 * 9.8 * 0.1);
                energy = energyOf(ball, laws);
            }
        }
    }
}

/// Between two floors that are nearer to each other than it is wide, and between copies that touch.
void TestExtremes::aBallInANarrowGapStays()
{
    const auto model = modelOf(floorMesh(1));
    Ground ground({{.model = model}, {.model = model, .worldFromModel = mapFromParts({0, 0.15, 0}, {}, {1, 1, 1})}});
    const Laws laws;
    BallState ball = ballAt({0.1, 0.06, 0}, 0.1, 0.5);
    const double energy = energyOf(ball, laws);
    for (int step = 0; step < 1000; ++step) {
        QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
        QVERIFY(ball.position.y > 0 && ball.position.y < 0.15);
        QVERIFY(energyOf(ball, laws) <= energy + 9.8 * 0.1);
    }
    QVERIFY(std::abs(ball.position.x - 0.1) < 0.01);
}

void TestExtremes::radiiOfEverySize_data()
{
    QTest::addColumn<double>("radius");
    for (const double radius : {1e-9, 1e-8, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
        QTest::addRow("%g", radius) << radius;
    }
}

/// Dropped on a sponge of size 2.
void TestExtremes::radiiOfEverySize()
{
    QFETCH(const double, radius);
    Ground ground(QStringLiteral("menger"), 4);
    const Laws laws;
    for (const double e : {0.0, 0.7, 1.0}) {
        BallState ball = ballAt({0.123, 2 + radius, 0.234}, radius, e, {0.1, 0, 0});
        unsigned contacts = 0;
        for (int step = 0; step < 240; ++step) {
            const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
            contacts += report.contacts;
            QVERIFY(!report.isExhausted);
            QVERIFY(std::isfinite(glm::length(ball.position)) && std::isfinite(glm::length(ball.velocity)));
            const double in = 1 - ground.distance(ball.position) / radius;
            QVERIFY2(in <= 1e-3, qPrintable(QStringLiteral("step %1: %2").arg(step).arg(in)));
        }
        QVERIFY(contacts > 0 || radius < 1e-2);
    }
}

void TestExtremes::stepsOfEveryLength_data()
{
    QTest::addColumn<double>("timeStep");
    for (const double timeStep : {1e-9, 1e-6, 1e-3, 0.1, 1.0, 10.0}) {
        QTest::addRow("%g s", timeStep) << timeStep;
    }
}

void TestExtremes::stepsOfEveryLength()
{
    QFETCH(const double, timeStep);
    Ground ground({{.model = modelOf(QStringLiteral("two-sets"), 3)}, {.model = modelOf(boxMesh(3))}});
    Laws laws;
    laws.timeStep = timeStep;
    std::mt19937_64 random(11);
    for (int round = 0; round < 20; ++round) {
        BallState ball = ballAt({uniform(random, -2, 2), 2.7, uniform(random, -2, 2)}, 0.05, uniform(random, 0, 0.9),
                                randomPoint(random, 10));
        for (int step = 0; step < 20; ++step) {
            stepBall(ball, laws, ground.probe, laws.timeStep);
            QVERIFY(ground.distance(ball.position) >= 0.05 * (1 - 1e-3));
            const glm::dvec3 p = glm::abs(ball.position);
            QVERIFY(std::max({p.x, p.y, p.z}) < 3);
        }
    }
    BallState ball = ballAt({0, 2.7, 0}, 0.05);
    stepBall(ball, laws, ground.probe, 0.0);
    QVERIFY(ball.position == glm::dvec3(0, 2.7, 0));
}

/// e = 0 leaves nothing of the speed across a plane, e = 1 all of it.
void TestExtremes::restitutionsAtTheEnds()
{
    Ground ground(floorMesh(10));
    const Laws laws;
    for (const double e : {0.0, 1.0}) {
        BallState ball = ballAt({0, 0.5, 0}, 0.1, e, {1, 0, 0});
        double highest = 0;
        bool hasLanded = false;
        for (int step = 0; step < 480; ++step) {
            hasLanded |= stepBall(ball, laws, ground.probe, laws.timeStep).contacts > 0;
            highest = hasLanded ? std::max(highest, ball.position.y) : 0;
            QVERIFY(std::abs(ball.velocity.x - 1) < 1e-9);
        }
        QVERIFY2(e == 0 ? highest < 0.1 * (1 + 1e-3) : std::abs(highest - 0.5) < 1e-3,
                 qPrintable(QString::number(highest)));
    }
}

void TestExtremes::nothingToFallOn()
{
    Ground ground(std::vector<SceneItem>{});
    const Laws laws;
    BallState ball = ballAt({0, 0, 0}, 0.1);
    for (int step = 1; step <= 240; ++step) {
        QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
    }
    QVERIFY(std::abs(ball.position.y + 4.9) < 1e-11);
}

void TestExtremes::farAwayAndForEver()
{
    Ground ground(floorMesh(1));
    Laws laws;
    BallState ball = ballAt({0, -1, 0}, 0.1);
    laws.timeStep = 10;
    laws.gravity = {0, -1e90, 0};
    for (int step = 0; step < 100; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    laws.gravity *= 1e10;
    for (int step = 0; step < 100; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    QVERIFY(std::isfinite(ball.position.y) && ball.position.y < -1e90);
}

/// Needles, points, and a surface that a place makes flat: two-sided shells.
void TestExtremes::flatAndDegenerateFacesHold()
{
    Mesh mesh = floorMesh(1);
    mesh.vertices.insert(mesh.vertices.end(), {{0, 0.2, 0}, {1e-9, 0.2, 0}, {0.5, 0.2, 0}});
    mesh.faces.push_back({4, 4, 4});
    mesh.faces.push_back({4, 5, 6});
    Ground ground(mesh);
    Ground flat({{.model = modelOf(boxMesh(1)), .worldFromModel = mapFromParts({}, {}, {1, 0, 1})}});
    const Laws laws;
    for (Ground *each : {&ground, &flat}) {
        for (const double side : {1.0, -1.0}) {
            Laws turned = laws;
            turned.gravity *= side;
            for (const double x : {-0.4, 0.0, 0.2}) {
                BallState ball = ballAt({x, side * 0.9, 0.001}, 0.05, 0.6);
                for (int step = 0; step < 300; ++step) {
                    QVERIFY(!stepBall(ball, turned, each->probe, turned.timeStep).isExhausted);
                    QVERIFY(each->distance(ball.position) >= 0.05 * (1 - 1e-3));
                    QVERIFY(side * ball.position.y > 0 || std::abs(ball.position.x) > 1
                            || std::abs(ball.position.z) > 1);
                }
            }
        }
    }
}

}

ROMANESCO_TEST(romanesco::test::TestExtremes)

#include "testextremes.moc"
