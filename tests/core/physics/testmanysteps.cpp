// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/physics/world.h"
#include "tests/core/collide/meshes.h"
#include "tests/core/physics/longer.h"
#include "tests/core/physics/referee.h"
#include "tests/testmain.h"

namespace romanesco::test {

/// What the laws promise for as long as one likes. The long programme does ten times as much, which the comments tell.
class TestManySteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bouncesKeepTheEnergy_data();
    void bouncesKeepTheEnergy();
    void restIsRest_data();
    void restIsRest();
    void lawsHold_data();
    void lawsHold();
    void coplanarCopiesDoNotBump();
    void thousandsLieOnOneAnother();
};

void TestManySteps::bouncesKeepTheEnergy_data()
{
    QTest::addColumn<Mesh>("mesh");
    QTest::addColumn<glm::dvec3>("gravity");
    QTest::addColumn<double>("radius");
    for (const double radius : {0.1, 1e-3, 1e-5}) {
        QTest::addRow("on a floor, r = %g", radius) << floorMesh(10) << glm::dvec3(0, -9.8, 0) << radius;
        QTest::addRow("in a box, r = %g", radius) << boxMesh(1) << glm::dvec3(0) << radius;
        QTest::addRow("in a falling box, r = %g", radius) << boxMesh(0.1 + radius) << glm::dvec3(1, -9.8, 2) << radius;
    }
}

/// A hundred thousand without loss.
void TestManySteps::bouncesKeepTheEnergy()
{
    QFETCH(const Mesh, mesh);
    QFETCH(const glm::dvec3, gravity);
    QFETCH(const double, radius);
    Ground ground(mesh);
    Laws laws;
    laws.gravity = gravity;
    const bool isFloor = mesh.faces.size() == 2;
    BallState ball = ballAt({0.01, isFloor ? radius + 0.005 : 0.02, 0.03}, radius, 1,
                            isFloor ? glm::dvec3(1e-4, 0, 0) : glm::dvec3(1.1, 4, 2.3));
    // from the lowest place that it comes to
    const glm::dvec3 low = isFloor ? glm::dvec3(0, radius, 0) : glm::sign(gravity) * 0.1;
    const auto energy = [&] { return energyOf(ball, laws) + glm::dot(gravity, low); };
    const double before = energy();
    std::uint64_t bounces = 0;
    while (bounces < std::uint64_t(10'000 * times())) {
        const StepReport report = stepBall(ball, laws, ground.probe, laws.timeStep);
        QVERIFY(!report.isExhausted);
        bounces += report.contacts;
    }
    QVERIFY2(std::abs(energy() / before - 1) < 1e-6, qPrintable(QString::number(energy() / before - 1)));
}

void TestManySteps::restIsRest_data()
{
    QTest::addColumn<std::vector<SceneItem>>("items");
    const auto row = [](const char *name, const std::shared_ptr<const Model> &model, const AffineMap &place = {}) {
        QTest::newRow(name) << std::vector<SceneItem>{{.model = model, .worldFromModel = place}};
    };
    row("a floor", modelOf(floorMesh(10)));
    row("a groove", modelOf(grooveMesh(1, 1)));
    row("a steep groove", modelOf(grooveMesh(1, 5)));
    row("a corner", modelOf(boxMesh(1)), mapFromParts({}, {35, 20, 45}, {1, 1, 1}));
    row("a bowl", modelOf(ball(40)), mapFromParts({}, {12, 34, 56}, {1, 1, 1}));
    row("a hole of a sponge", modelOf(QStringLiteral("menger"), 3), mapFromParts({0.64, -2, -0.7}, {}, {1, 1, 1}));
}

/// A million steps, asleep and woken before each, move it nowhere.
void TestManySteps::restIsRest()
{
    QFETCH(const std::vector<SceneItem>, items);
    Ground ground(items);
    const Laws laws;
    BallState ball = ballAt({0.02, 0.55, 0.03}, 0.13, 0.4);
    for (int step = 0; step < 100'000 && !ball.isAsleep; ++step) {
        stepBall(ball, laws, ground.probe, laws.timeStep);
    }
    QVERIFY(ball.isAsleep);
    const BallState rested = ball;
    for (const bool isWoken : {false, true}) {
        for (int step = 0; step < 100'000 * times(); ++step) {
            ball.isAsleep = ball.isAsleep && !isWoken;
            stepBall(ball, laws, ground.probe, laws.timeStep);
            QVERIFY(ball.isAsleep);
        }
        QVERIFY(ball.position == rested.position && ball.velocity == glm::dvec3(0));
    }
}

void TestManySteps::lawsHold_data()
{
    QTest::addColumn<std::vector<SceneItem>>("items");
    const AffineMap turned = mapFromParts({0.3, -0.2, 0.1}, {25, -40, 70}, {1, 1, 1});
    const SceneItem box{.model = modelOf(boxMesh(2.5))};
    const auto row = [&](const char *name, const QString &example, std::uint64_t depth, const AffineMap &place = {}) {
        QTest::newRow(name) << std::vector<SceneItem>{{.model = modelOf(example, depth), .worldFromModel = place}, box};
    };
    row("Menger's sponge", QStringLiteral("menger"), 2);
    row("a turned sponge", QStringLiteral("menger"), 2, turned);
    row("two sets", QStringLiteral("two-sets"), 2);
    row("a turned tree", QStringLiteral("tree"), 5, turned);
}

/// Balls of many sizes, speeds and restitutions for seconds: all along their paths none sinks in, wins energy, or leaves a
/// contact against it; and of all steps hardly one is not done.
void TestManySteps::lawsHold()
{
    QFETCH(const std::vector<SceneItem>, items);
    Ground ground(items);
    const WrittenSurface surface(items);
    std::mt19937_64 random(seed(21));
    const Laws laws;
    Referee referee(surface);
    const int rounds = 10 * times();
    for (int round = 0; round < rounds; ++round) {
        BallState ball;
        do {
            ball = ballAt(randomPoint(random, 2.4), std::pow(10.0, uniform(random, -4, -0.8)),
                          std::clamp(uniform(random, -0.5, 1.5), 0.0, 1.0),
                          std::pow(10.0, uniform(random, -1, 2.5)) * randomPoint(random, 1));
        } while (surface.distance(ball.position, ball.position, 2 * ball.radius) < 1.001 * ball.radius);
        for (int step = 0; step < 1000 && !ball.isAsleep; ++step) {
            referee.step(ball, laws, ground.probe);
            const auto words = [&](const char *what, double number) {
                return qPrintable(QStringLiteral("%1 %2: round %3, step %4, r %5, e %6")
                                      .arg(QLatin1String(what))
                                      .arg(number)
                                      .arg(round)
                                      .arg(step)
                                      .arg(ball.radius)
                                      .arg(ball.restitution));
            };
            QVERIFY2(referee.penetration <= 1e-3, words("penetration", referee.penetration));
            QVERIFY2(referee.won <= 1.0, words("won", referee.won));
            QVERIFY2(referee.against <= 2e-4, words("against", referee.against));
        }
    }
    QVERIFY(referee.contacts > 10 * std::uint64_t(rounds));
    QVERIFY(static_cast<double>(referee.exhausted) <= 1e-5 * static_cast<double>(referee.steps));
}

/// Of a plate of plates, two hundred times as wide as one, and turned: at all speeds and sizes.
void TestManySteps::coplanarCopiesDoNotBump()
{
    const AffineMap place = mapFromParts({1, 2, 3}, {33, 21, -50}, {1, 1, 1});
    std::vector<SceneItem> items;
    const auto model = modelOf(plate(8));
    for (int i = -8; i < 8; ++i) {
        for (int k = -8; k < 8; ++k) {
            items.push_back({.model = model, .worldFromModel = place * AffineMap{glm::dmat3(1.0), {8 * i, 0, 8 * k}}});
        }
    }
    Ground ground(items);
    Laws laws;
    const glm::dvec3 n = place.linear * glm::dvec3(0, 1, 0);
    laws.gravity = -9.8 * n;
    std::mt19937_64 random(seed(22));
    for (int round = 0; round < 30 * times(); ++round) {
        const double radius = std::pow(10.0, uniform(random, -4, 0));
        const double angle = uniform(random, 0, 6.28);
        const double speed = std::pow(10.0, uniform(random, -2, 1.2));
        const glm::dvec3 v = place.linear * glm::dvec3(speed * std::cos(angle), 0, speed * std::sin(angle));
        const glm::dvec3 start = place({uniform(random, -2, 2), radius * (1 + 5e-5), uniform(random, -2, 2)});
        BallState ball = ballAt(start, radius, uniform(random, 0, 1));
        stepBall(ball, laws, ground.probe, laws.timeStep);
        QVERIFY(ball.isAsleep && ball.position == start);
        ball.isAsleep = false;
        ball.velocity = v;
        for (int step = 1; step <= 900; ++step) {
            QVERIFY(!stepBall(ball, laws, ground.probe, laws.timeStep).isExhausted);
            const double off = glm::distance(ball.position, start + step * laws.timeStep * v);
            QVERIFY2(off < 1e-8 && glm::distance(ball.velocity, v) < 1e-8,
                     qPrintable(QStringLiteral("round %1, step %2: %3").arg(round).arg(step).arg(off)));
        }
    }
}

/// Five thousand in a box, which fall on one another for two seconds.
void TestManySteps::thousandsLieOnOneAnother()
{
    const int count = 500 * times();
    const int side = static_cast<int>(std::lround(std::cbrt(count)));
    constexpr double radius = 0.05;
    const double half = 1.1 * side * radius;
    Ground ground(boxMesh(half));
    World world(ground.surface, {});
    std::mt19937_64 random(seed(23));
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 place(i % side, i / (side * side), i / side % side);
        world.add({2.02 * radius * place + randomPoint(random, 0.005 * radius) - glm::dvec3(half - 1.3 * radius),
                   {},
                   radius * uniform(random, 0.9, 1),
                   0.3});
    }
    const auto overlap = [&] {
        double worst = 0.0;
        const auto balls = world.balls();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                const glm::dvec3 apart = balls[i].position - balls[k].position;
                const double sum = balls[i].radius + balls[k].radius;
                if (glm::dot(apart, apart) < sum * sum) {
                    worst = std::max(worst, (sum - glm::length(apart)) / std::min(balls[i].radius, balls[k].radius));
                }
            }
        }
        return worst;
    };
    double worst = 0.0;
    for (int step = 0; step < 480; ++step) {
        world.step();
        if (step % 20 == 19) {
            worst = std::max(worst, overlap());
        }
        for (const BallState &ball : world.balls()) {
            const glm::dvec3 p = glm::abs(ball.position);
            QVERIFY(std::max({p.x, p.y, p.z}) <= half - ball.radius * (1 - 1e-3));
        }
    }
    QVERIFY2(worst <= 0.05, qPrintable(QString::number(worst)));
    QCOMPARE(world.lostSteps(), std::uint64_t{0});
}

}

ROMANESCO_TEST(romanesco::test::TestManySteps)

#include "testmanysteps.moc"
