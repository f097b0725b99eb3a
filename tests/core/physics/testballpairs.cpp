// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <QTest>

#include "core/physics/ballpairs.h"
#include "core/physics/world.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

glm::dvec3 momentumOf(const World &world)
{
    glm::dvec3 sum(0.0);
    for (const BallState &ball : world.balls()) {
        sum += std::pow(ball.radius, 3) * ball.velocity;
    }
    return sum;
}

double energyOfAll(const World &world)
{
    double sum = 0.0;
    for (const BallState &ball : world.balls()) {
        sum += std::pow(ball.radius, 3) * energyOf(ball, world.options().laws);
    }
    return sum;
}

/// Of the smaller of two balls, how deep they are in each other at most.
double worstOverlap(const World &world)
{
    double worst = 0.0;
    const auto balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const double overlap =
                balls[i].radius + balls[k].radius - glm::distance(balls[i].position, balls[k].position);
            worst = std::max(worst, overlap / std::min(balls[i].radius, balls[k].radius));
        }
    }
    return worst;
}

World::Options weightless()
{
    World::Options options{.threads = 1};
    options.laws.gravity = glm::dvec3(0.0);
    return options;
}

}

class TestBallPairs : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearPairsAreAllThatMayMeet();
    void twoBallsAreTheClosedForm();
    void fastBallsDoNotPassThroughEachOther();
    void aRowPassesABlowOn();
    void aGasKeepsMomentumAndEnergy();
    void aBallThatIsHitWakes();
    void whatStandsOnABallStaysAndSleeps();
    void aHeapComesToRest();
    void anyNumberOfThreadsComesToTheSame();
};

/// Of all sizes, near and far, beside one another, in one another and at one place: as looking at all pairs finds.
void TestBallPairs::nearPairsAreAllThatMayMeet()
{
    std::mt19937_64 random(seed(11));
    const Laws laws;
    std::size_t found = 0;
    for (int round = 0; round < 60; ++round) {
        const double half = std::pow(10.0, uniform(random, -3, 3));
        const glm::dvec3 middle = round % 3 == 0 ? glm::dvec3(0) : randomPoint(random, round % 3 == 1 ? 100 : 1e17);
        std::vector<BallState> balls;
        for (int i = 0; i < 150; ++i) {
            BallState ball =
                ballAt(middle + randomPoint(random, half), half * std::pow(10.0, uniform(random, -3, -0.5)));
            ball.velocity = randomPoint(random, half * std::pow(10.0, uniform(random, -2, 2)));
            ball.isAsleep = random() % 4 == 0;
            ball.isPiled = random() % 4 == 0;
            ball.place = random() % 8 == 0 ? 1 : 0;
            balls.push_back(i % 10 == 9 ? balls.back() : ball);
        }
        std::vector<BallPair> expected;
        for (std::size_t i = 0; i < balls.size(); ++i) {
            for (std::size_t k = i + 1; k < balls.size(); ++k) {
                const auto way = [&](const BallState &ball) {
                    return ball.isAsleep ? 0.0 : glm::length(ball.velocity) * 0.01 + 0.5 * 9.8 * 1e-4;
                };
                const double reach = 1.001 * (balls[i].radius + balls[k].radius) + way(balls[i]) + way(balls[k]);
                const bool counts = balls[i].place == balls[k].place
                    && (!balls[i].isAsleep || !balls[k].isAsleep || (balls[i].isPiled && balls[k].isPiled));
                const double distance = glm::distance(balls[i].position, balls[k].position);
                if (counts && distance <= reach * (1 - 1e-12)) {
                    expected.push_back({i, k});
                }
            }
        }
        std::vector<double> reaches;
        for (const BallState &ball : balls) {
            reaches.push_back(reachOf(ball, laws, 0.01));
        }
        const std::vector<BallPair> pairs = nearPairs(balls, reaches);
        QVERIFY(std::ranges::includes(pairs, expected));
        QVERIFY(std::ranges::adjacent_find(pairs) == pairs.end());
        QVERIFY(pairs.size() <= expected.size() + 1);
        found += expected.size();
    }
    QVERIFY(found > 10'000);
}

/// Two in space, of any sizes, restitutions and speeds, that meet off their middles within one step or later.
void TestBallPairs::twoBallsAreTheClosedForm()
{
    Ground ground(std::vector<SceneItem>{});
    std::mt19937_64 random(seed(12));
    for (int round = 0; round < 500; ++round) {
        World world(ground.surface, weightless());
        const double r1 = uniform(random, 0.01, 1);
        const double r2 = uniform(random, 0.01, 1);
        const double e1 = uniform(random, 0, 1);
        const double e2 = uniform(random, 0, 1);
        const glm::dvec3 n = glm::normalize(randomPoint(random, 1));
        const glm::dvec3 v1 = randomPoint(random, std::pow(10.0, uniform(random, -1, 3)));
        const glm::dvec3 v2 = v1 + randomPoint(random, 1) * glm::length(v1);
        const double against = -glm::dot(v1 - v2, n);
        if (against < 0.01 * glm::length(v1)) {
            continue;
        }
        const double when = uniform(random, 0, 3) / 240;
        world.add({(r1 + r2) * n - when * v1, v1, r1, e1});
        world.add({-when * v2, v2, r2, e2});
        for (int step = 0; step < 4; ++step) {
            world.step();
        }
        const double m1 = r1 * r1 * r1;
        const double m2 = r2 * r2 * r2;
        const double impulse = (1 + std::sqrt(e1 * e2)) * against * m1 * m2 / (m1 + m2);
        const glm::dvec3 w1 = v1 + impulse / m1 * n;
        const glm::dvec3 w2 = v2 - impulse / m2 * n;
        const double after = 4.0 / 240 - when;
        const double speed = glm::length(v1) + glm::length(v2) + glm::length(w1) + glm::length(w2);
        QVERIFY2(glm::distance(world.balls()[0].velocity, w1) < 1e-9 * speed, qPrintable(QString::number(round)));
        QVERIFY(glm::distance(world.balls()[1].velocity, w2) < 1e-9 * speed);
        QVERIFY(glm::distance(world.balls()[0].position, (r1 + r2) * n + after * w1) < 1e-9 * (1 + speed));
        QVERIFY(glm::distance(world.balls()[1].position, after * w2) < 1e-9 * (1 + speed));
    }
}

void TestBallPairs::fastBallsDoNotPassThroughEachOther()
{
    Ground ground(std::vector<SceneItem>{});
    for (const double way : {1.0, 100.0, 1e4}) {
        World world(ground.surface, weightless());
        const double radius = 0.01;
        const double speed = way * radius * 240;
        world.add({{-0.3 * way * radius - 0.1, 0, 0}, {speed, 0, 0}, radius, 1});
        world.add({{0.3 * way * radius + 0.1, 0, 0}, {-speed, 0, 0}, radius, 1});
        for (int step = 0; step < 60; ++step) {
            world.step();
            QVERIFY(world.balls()[0].position.x < world.balls()[1].position.x);
        }
        QVERIFY(std::abs(world.balls()[0].velocity.x + speed) < 1e-9 * speed);
    }
}

/// As Newton's cradle: the last goes, the others stay.
void TestBallPairs::aRowPassesABlowOn()
{
    Ground ground(std::vector<SceneItem>{});
    World world(ground.surface, weightless());
    for (int i = 0; i < 5; ++i) {
        world.add({{0.21 * i, 0, 0}, {i == 0 ? 3.0 : 0.0, 0, 0}, 0.1, 1});
    }
    for (int step = 0; step < 240; ++step) {
        world.step();
    }
    for (int i = 0; i < 5; ++i) {
        QVERIFY(std::abs(world.balls()[static_cast<std::size_t>(i)].velocity.x - (i == 4 ? 3 : 0)) < 1e-9);
    }
}

/// In a box, without loss and without gravity; momentum alone, in space.
void TestBallPairs::aGasKeepsMomentumAndEnergy()
{
    Ground box(boxMesh(1));
    Ground space(std::vector<SceneItem>{});
    for (Ground *ground : {&box, &space}) {
        std::mt19937_64 random(seed(13));
        World world(ground->surface, weightless());
        for (int i = 0; i < 64; ++i) {
            const glm::dvec3 place(i % 4, i / 4 % 4, i / 16);
            world.add({0.4 * place - glm::dvec3(0.6), randomPoint(random, 2), uniform(random, 0.05, 0.15), 1});
        }
        const glm::dvec3 momentum = momentumOf(world);
        const double energy = energyOfAll(world);
        for (int step = 0; step < 480; ++step) {
            world.step();
            QVERIFY(std::abs(energyOfAll(world) / energy - 1) < 1e-9);
            QVERIFY(worstOverlap(world) < 1e-6);
            QVERIFY(ground == &box || glm::distance(momentumOf(world), momentum) < 1e-12);
        }
        QCOMPARE(world.lostSteps(), std::uint64_t{0});
    }
}

void TestBallPairs::aBallThatIsHitWakes()
{
    Ground ground(floorMesh(10));
    World world(ground.surface, {.threads = 1});
    world.add({{0, 0.1, 0}, {}, 0.1, 0.5});
    for (int step = 0; step < 30; ++step) {
        world.step();
    }
    QVERIFY(world.balls()[0].isAsleep);
    world.add({{-1, 0.1, 0}, {3, 0, 0}, 0.1, 0.5});
    for (int step = 0; step < 240; ++step) {
        world.step();
    }
    QVERIFY(!world.balls()[0].isAsleep);
    QVERIFY2(std::abs(world.balls()[0].velocity.x - 2.25) < 1e-3,
             qPrintable(QString::number(world.balls()[0].velocity.x)));
    QVERIFY(std::abs(world.balls()[1].velocity.x - 0.75) < 1e-3);
}

void TestBallPairs::whatStandsOnABallStaysAndSleeps()
{
    Ground ground(floorMesh(10));
    World world(ground.surface, {.threads = 1});
    for (int i = 0; i < 5; ++i) {
        world.add({{0, 0.1 + 0.2 * i, 0}, {}, 0.1, 0.5});
    }
    for (int step = 0; step < 480; ++step) {
        world.step();
        QVERIFY2(worstOverlap(world) < 0.05, qPrintable(QString::number(worstOverlap(world))));
    }
    for (std::size_t i = 0; i < 5; ++i) {
        QVERIFY(world.balls()[i].isAsleep);
        QVERIFY(std::abs(world.balls()[i].position.y - (0.1 + 0.2 * static_cast<double>(i))) < 0.01);
    }
    const std::uint64_t lost = world.lostSteps();
    const glm::dvec3 place = world.balls()[4].position;
    for (int step = 0; step < 1000; ++step) {
        world.step();
    }
    QVERIFY(world.balls()[4].position == place && world.lostSteps() == lost);
}

/// Poured into a box.
void TestBallPairs::aHeapComesToRest()
{
    Ground ground(boxMesh(0.5));
    World world(ground.surface, {.threads = 1});
    std::mt19937_64 random(seed(14));
    for (int i = 0; i < 125; ++i) {
        const glm::dvec3 place(i % 5, i / 25, i / 5 % 5);
        world.add({0.18 * place - glm::dvec3(0.36, 0.4, 0.36) + randomPoint(random, 0.01),
                   {},
                   uniform(random, 0.05, 0.08),
                   uniform(random, 0, 0.8)});
    }
    double worst = 0.0;
    for (int step = 0; step < 960; ++step) {
        world.step();
        worst = std::max(worst, worstOverlap(world));
        for (const BallState &ball : world.balls()) {
            const glm::dvec3 p = glm::abs(ball.position);
            QVERIFY(std::max({p.x, p.y, p.z}) <= 0.5 - ball.radius * (1 - 1e-3));
        }
    }
    QVERIFY2(worst < 0.08, qPrintable(QString::number(worst)));
    QVERIFY2(worstOverlap(world) < 0.05, qPrintable(QString::number(worstOverlap(world))));
    double fastest = 0.0;
    for (const BallState &ball : world.balls()) {
        fastest = std::max(fastest, glm::length(ball.velocity));
    }
    QVERIFY2(fastest < 0.3, qPrintable(QString::number(fastest)));
}

void TestBallPairs::anyNumberOfThreadsComesToTheSame()
{
    Ground ground(boxMesh(1));
    World one(ground.surface, {.threads = 1});
    World three(ground.surface, {.threads = 3});
    for (World *world : {&one, &three}) {
        std::mt19937_64 random(seed(15));
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 place(i % 6, i / 36, i / 6 % 6);
            world->add({0.3 * place - glm::dvec3(0.75), randomPoint(random, 3), uniform(random, 0.05, 0.14),
                        uniform(random, 0, 1)});
        }
    }
    for (int step = 0; step < 120; ++step) {
        one.step();
        three.step();
        QCOMPARE(three.stateHash(), one.stateHash());
    }
}

}

ROMANESCO_TEST(romanesco::test::TestBallPairs)

#include "testballpairs.moc"
