// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/physics/recording.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Not at the box round it.
bool isAtSponge(const BallState &ball)
{
    const glm::dvec3 p = glm::abs(ball.position);
    return std::max({p.x, p.y, p.z}) < 1.5 + 2 * ball.radius;
}

}

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
    void speedsOfEverySize_data();
    void speedsOfEverySize();
    void gravityOfEverySize_data();
    void gravityOfEverySize();
    void farFromTheOrigin_data();
    void farFromTheOrigin();
    void aMillionSteps();
    void restitutionsAtTheEnds();
    void recordingsOfNoNumbersAreRefused();
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

/// Dropped on a sponge, where its edge has no holes.
void TestExtremes::radiiOfEverySize()
{
    QFETCH(const double, radius);
    Ground ground(QStringLiteral("menger"), 4);
    const Laws laws;
    for (const double e : {0.0, 0.7, 1.0}) {
        BallState ball = ballAt({-1.4, 2 + radius, -1.49}, radius, e, {0.1, 0, 0});
        unsigned contacts = 0;
        for (int step = 0; step < 240; ++step) {
            const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
            contacts += report.contacts;
            QVERIFY(!report.isExhausted);
            QVERIFY(std::isfinite(glm::length(ball.position)) && std::isfinite(glm::length(ball.velocity)));
            const double in = 1 - ground.distance(ball.position) / radius;
            QVERIFY2(in <= 1e-3, qPrintable(QStringLiteral("step %1: %2").arg(step).arg(in)));
        }
        QVERIFY(contacts > 0);
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
    std::mt19937_64 random(seed(11));
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

void TestExtremes::speedsOfEverySize_data()
{
    QTest::addColumn<double>("way");
    for (const double way : {0.0, 1e-12, 1.0, 1e4, 1e6, 1e12, 1e100}) {
        QTest::addRow("%g radii a step", way) << way;
    }
}

/// In a closed box none is let out; a ball that bounces more often than there is time for loses the rest of the step.
void TestExtremes::speedsOfEverySize()
{
    QFETCH(const double, way);
    Ground ground(boxMesh(1));
    const Laws laws;
    for (const double e : {0.0, 0.5, 1.0}) {
        for (const glm::dvec3 &along : {glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0, 0.8), glm::dvec3(0.36, -0.48, 0.8)}) {
            const double radius = 1e-3;
            BallState ball = ballAt({0.1, 0.2, 0.3}, radius, e, way * radius / laws.timeStep * along);
            for (int step = 0; step < 10; ++step) {
                const double energy = energyOf(ball, laws);
                const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
                QVERIFY(!report.isExhausted || way > 1e4);
                const glm::dvec3 p = glm::abs(ball.position);
                QVERIFY(std::max({p.x, p.y, p.z}) <= 1 - radius * (1 - 1e-3));
                QVERIFY(energyOf(ball, laws) <= energy * (1 + 1e-9) + 1e-3 * 9.8 * radius);
            }
        }
    }
}

void TestExtremes::gravityOfEverySize_data()
{
    QTest::addColumn<double>("gravity");
    for (const double gravity : {0.0, 1e-300, 1e-9, 1e4, 1e9, 1e15, 1e100}) {
        QTest::addRow("%g", gravity) << gravity;
    }
}

/// On the sponge's rim, which has no holes, and over the edge of its largest hole.
void TestExtremes::gravityOfEverySize()
{
    QFETCH(const double, gravity);
    Ground ground({{.model = modelOf(QStringLiteral("menger"), 3)}, {.model = modelOf(boxMesh(3))}});
    Laws laws;
    laws.gravity = {0, -gravity, 0};
    for (const glm::dvec3 &start : {glm::dvec3(-1.45, 1.7, 0.234), glm::dvec3(0.4995, 1.7, 0.234)}) {
        for (const double radius : {0.1, 1e-3}) {
            for (const double e : {0.0, 0.5, 1.0}) {
                BallState ball = ballAt(start, radius, e);
                unsigned contacts = 0;
                for (int step = 0; step < 50; ++step) {
                    const double energy = energyOf(ball, laws);
                    contacts += stepBall(ball, laws, ground.probe, laws.timeStep).contacts;
                    QVERIFY(ground.distance(ball.position) >= radius * (1 - 1e-3));
                    const glm::dvec3 p = glm::abs(ball.position);
                    QVERIFY(std::max({p.x, p.y, p.z}) < 3);
                    QVERIFY(energyOf(ball, laws) <= energy + (1e-12 * std::abs(energy) + 1e-3 * gravity * radius));
                }
                QVERIFY(gravity > 1e-9 || glm::distance(ball.position, start) < 1e-9);
                QVERIFY2(gravity < 1 || contacts > 0, qPrintable(QStringLiteral("%1 %2").arg(radius).arg(e)));
            }
        }
    }
}

void TestExtremes::farFromTheOrigin_data()
{
    QTest::addColumn<double>("offset");
    for (const double offset : {1e3, 1e6, 1e9, 1e12, 1e15, 1e30, 1e100}) {
        QTest::addRow("%g", offset) << offset;
    }
}

/// Up to a rounding that is a tenth of its radius a ball does what it does at the origin, to what its skin grows to; farther away
/// it stays a number, and outside by as much as the surface is known there.
void TestExtremes::farFromTheOrigin()
{
    QFETCH(const double, offset);
    const glm::dvec3 away = offset * glm::dvec3(1, -0.5, 0.25);
    Ground here({{.model = modelOf(boxMesh(1))}});
    Ground there({{.model = modelOf(boxMesh(1)), .worldFromModel = AffineMap{glm::dmat3(1.0), away}}});
    const double radius = 0.1;
    const double rounding = there.probe.roundingAt(away);
    const Laws laws;
    BallState near = ballAt({0.1, 0.2, 0.3}, radius, 0.5, {0.5, 0, -0.25});
    BallState far = ballAt(near.position + away, radius, 0.5, near.velocity);
    for (int step = 0; step < 240; ++step) {
        stepBall(near, laws, here.probe, laws.timeStep);
        stepBall(far, laws, there.probe, laws.timeStep);
        QVERIFY(std::isfinite(glm::length(far.position / offset)) && std::isfinite(glm::length(far.velocity)));
        QVERIFY(there.distance(far.position) >= radius * (1 - 1e-3) - 16 * rounding);
        if (rounding < 1e-3 * radius) {
            const glm::dvec3 off = far.position - away - near.position;
            QVERIFY2(glm::length(off) < 1e-3 * radius + 200 * rounding,
                     qPrintable(QStringLiteral("step %1: %2 of %3").arg(step).arg(glm::length(off)).arg(rounding)));
        }
    }
}

/// In a box with a sponge, without loss and with some: it is held, and wins nothing.
void TestExtremes::aMillionSteps()
{
    Ground ground({{.model = modelOf(QStringLiteral("menger"), 3)}, {.model = modelOf(boxMesh(3))}});
    const Laws laws;
    for (const double e : {0.5, 1.0}) {
        BallState ball = ballAt({-1.45, 1.7, 0.234}, 0.05, e, {0.2, 0, -0.1});
        const double energy = energyOf(ball, laws);
        std::uint64_t contacts = 0;
        std::uint64_t atSponge = 0;
        for (int step = 0; step < 1'000'000; ++step) {
            const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
            QVERIFY(!report.isExhausted);
            contacts += report.contacts;
            atSponge += isAtSponge(ball) ? report.contacts : 0;
        }
        QVERIFY(ground.distance(ball.position) >= 0.05 * (1 - 1e-3));
        const glm::dvec3 p = glm::abs(ball.position);
        QVERIFY(std::max({p.x, p.y, p.z}) < 3);
        QVERIFY2(contacts > 1000 && atSponge > (e < 1 ? 10u : 300u),
                 qPrintable(QStringLiteral("%1 and %2 at e = %3").arg(contacts).arg(atSponge).arg(e)));
        QVERIFY(energyOf(ball, laws) <= energy + 1e-3 * 9.8 * 0.05);
    }
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

/// Nor of what would become none.
void TestExtremes::recordingsOfNoNumbersAreRefused()
{
    const auto read = [](const std::string &line) {
        return recordingFromText("romanesco recording 1\n" + line + "\nend 1 00\n");
    };
    QVERIFY(read("time-step 10") && read("gravity 1e140 0 0") && read("at 0 drop 1e140 0 0 0 0 0 1e140 1"));
    QVERIFY(read("at 0 rules 10 0 -9.8 0 1 exact"));
    for (const char *number : {"nan", "inf", "-inf", "1e400", "1e300"}) {
        const std::string n(number);
        for (const std::string &line :
             {"time-step " + n, "gravity 0 " + n + " 0", "at 0 drop 0 0 " + n + " 0 0 0 1 1",
              "at 0 drop 0 0 0 " + n + " 0 0 1 1", "at 0 drop 0 0 0 0 0 0 " + n + " 1", "at 0 drop 0 0 0 0 0 0 1 " + n,
              "at 0 rules " + n + " 0 -9.8 0 1 exact", "at 0 rules 0.1 0 " + n + " 0 1 exact"}) {
            const auto recording = read(line);
            QVERIFY2(!recording && recording.error().starts_with("line 2: "), line.c_str());
        }
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
