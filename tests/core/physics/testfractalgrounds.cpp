// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

class TestFractalGrounds : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lawsHoldOnEachFractal_data();
    void lawsHoldOnEachFractal();
    void shotsTouchWhatIsThere_data();
    void shotsTouchWhatIsThere();
};

void TestFractalGrounds::lawsHoldOnEachFractal_data()
{
    QTest::addColumn<QString>("example");
    QTest::addColumn<std::uint64_t>("depth");
    QTest::newRow("Menger's sponge") << QStringLiteral("menger") << std::uint64_t{4};
    QTest::newRow("two sets") << QStringLiteral("two-sets") << std::uint64_t{3};
    QTest::newRow("tree") << QStringLiteral("tree") << std::uint64_t{7};
    QTest::newRow("appendix B") << QStringLiteral("appendix-b") << std::uint64_t{3};
    QTest::newRow("Sierpinski") << QStringLiteral("sierpinski") << std::uint64_t{6};
    QTest::newRow("terrain") << QStringLiteral("terrain") << std::uint64_t{5};
}

/// Balls of many sizes, speeds and restitutions in a box with a fractal: none sinks in, leaves the box, wins energy, or
/// is not done with a step.
void TestFractalGrounds::lawsHoldOnEachFractal()
{
    QFETCH(const QString, example);
    QFETCH(const std::uint64_t, depth);
    Ground ground({{.model = modelOf(example, depth)}, {.model = modelOf(boxMesh(3))}});
    std::mt19937_64 random(seed(7));
    const Laws laws;
    unsigned contacts = 0;
    for (int round = 0; round < 40; ++round) {
        const double radius = std::pow(10.0, uniform(random, -4, -0.8));
        const double speed = std::pow(10.0, uniform(random, -1, 2.5));
        const double e = round % 5 == 0 ? 0 : round % 5 == 1 ? 1 : uniform(random, 0, 1);
        BallState ball;
        do {
            ball = ballAt(randomPoint(random, 2.8), radius, e, speed * randomPoint(random, 1));
        } while (ground.distance(ball.position) < radius);
        double energy = energyOf(ball, laws);
        for (int step = 0; step < 1000 && !ball.isAsleep; ++step) {
            const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
            contacts += report.contacts;
            const auto words = [&](const char *what, double number) {
                return qPrintable(QStringLiteral("%1 %2: round %3, step %4, r %5, e %6")
                                      .arg(QLatin1String(what))
                                      .arg(number)
                                      .arg(round)
                                      .arg(step)
                                      .arg(radius)
                                      .arg(e));
            };
            QVERIFY2(!report.isExhausted, words("exhausted", report.queries));
            const double depthIn = 1 - ground.distance(ball.position) / radius;
            QVERIFY2(depthIn <= 1e-3, words("penetration", depthIn));
            const double now = energyOf(ball, laws);
            QVERIFY2(now <= energy + 1e-3 * 9.8 * radius + 1e-14 * std::abs(energy), words("won", now - energy));
            energy = now;
            const glm::dvec3 p = glm::abs(ball.position);
            QVERIFY2(std::max({p.x, p.y, p.z}) < 3, words("outside", radius));
        }
    }
    QVERIFY2(contacts > 500, qPrintable(QString::number(contacts)));
}

void TestFractalGrounds::shotsTouchWhatIsThere_data()
{
    lawsHoldOnEachFractal_data();
}

/// Shots without gravity, up to ten thousand radii long. Whether and where one touches first is found by going on by as much
/// as nothing is nearer, again and again, which asks no sweep.
void TestFractalGrounds::shotsTouchWhatIsThere()
{
    QFETCH(const QString, example);
    QFETCH(const std::uint64_t, depth);
    Ground ground(example, depth);
    const Sphere around = boundingSphere(ground.scene->items.front());
    std::mt19937_64 random(seed(8));
    Laws laws;
    laws.gravity = glm::dvec3(0);
    int touched = 0;
    int missed = 0;
    for (int round = 0; round < 400; ++round) {
        const double radius = around.radius * std::pow(10.0, uniform(random, -4.5, -1));
        const glm::dvec3 start = around.centre + randomPoint(random, 1.2 * around.radius);
        if (ground.distance(start) < 1.001 * radius) {
            continue;
        }
        const double length = std::min(radius * std::pow(10.0, uniform(random, 0, 4)), 3 * around.radius);
        glm::dvec3 along = glm::normalize(randomPoint(random, 1));
        if (round % 3 == 0) { // so that it grazes
            Hit hit;
            ground.search->closest({start}, hit);
            const glm::dvec3 aim = hit.point + radius * uniform(random, 0.9, 1.1) * glm::cross(hit.direction, along);
            along = glm::normalize(aim - start);
        }
        double way = 0.0;
        double nearest = std::numeric_limits<double>::infinity();
        while (way < length && nearest > 1e-7 * radius) {
            nearest = ground.distance(start + way * along) - radius;
            way += std::max(nearest, 0.0);
        }
        BallState ball = ballAt(start, radius, 1, length / laws.timeStep * along);
        const BallState before = ball;
        const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
        const bool isOnItsWay = report.contacts == 0; // between two walls velocities come back
        QVERIFY(std::abs(glm::length(ball.velocity) / glm::length(before.velocity) - 1) < 1e-12);
        QVERIFY(!report.isExhausted);
        if (way < 0.999 * length - radius) {
            QVERIFY2(!isOnItsWay,
                     qPrintable(QStringLiteral("%1: through at %2 of %3").arg(round).arg(way).arg(length)));
            ++touched;
        } else if (nearest > 1e-4 * radius && isOnItsWay) {
            QVERIFY(glm::distance(ball.position, start + length * along) < 1e-12);
            ++missed;
        }
        QVERIFY(ground.distance(ball.position) >= radius * (1 - 1e-9));
    }
    QVERIFY2(touched > 40 && missed > 20, qPrintable(QStringLiteral("%1 %2").arg(touched).arg(missed)));
}

}

ROMANESCO_TEST(romanesco::test::TestFractalGrounds)

#include "testfractalgrounds.moc"
