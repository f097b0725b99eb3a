// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/world.h"

#include <QTest>

#include "tests/core/collide/instructionsets.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Balls over all of a box, of many sizes and restitutions.
void addBalls(World &world, int count, double half)
{
    std::mt19937_64 random(9);
    for (int i = 0; i < count; ++i) {
        Ball ball;
        ball.position = randomPoint(random, half);
        ball.position.y = 2.5;
        ball.radius = uniform(random, 0.004, 0.04);
        ball.restitution = uniform(random, 0, 1);
        ball.velocity = randomPoint(random, 3);
        world.add(ball);
    }
}

}

class TestWorld : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void anyNumberOfThreadsComesToTheSame();
    void stepsAreTheSameBytesEverywhere_data();
    void stepsAreTheSameBytesEverywhere();
    void theHashTellsStatesApart();
    void surfacesAreSwappedUnderBalls();
    void eachColliderKeepsItsPromise_data();
    void eachColliderKeepsItsPromise();
    void ballsShrink();
    void aShrinkingBallFallsThrough();
    void asInTheDissertationEnergyIsLost();
    void asInTheDissertationBallsTunnel();
};

void TestWorld::anyNumberOfThreadsComesToTheSame()
{
    Ground ground({{.model = modelOf(QStringLiteral("two-sets"), 3)}, {.model = modelOf(boxMesh(3))}});
    World one(ground.surface, {.threads = 1});
    World two(ground.surface, {.threads = 2});
    World five(ground.surface, {.threads = 5});
    for (World *world : {&one, &two, &five}) {
        addBalls(*world, 300, 2);
    }
    for (int step = 0; step < 300; ++step) {
        one.step();
        two.step();
        five.step();
        QCOMPARE(two.stateHash(), one.stateHash());
        QCOMPARE(five.stateHash(), one.stateHash());
        for (std::size_t i = 0; i < one.balls().size(); ++i) {
            QCOMPARE(five.reports()[i].cost.faceTests, one.reports()[i].cost.faceTests);
            QCOMPARE(five.reports()[i].contacts, one.reports()[i].contacts);
        }
    }
}

void TestWorld::stepsAreTheSameBytesEverywhere_data()
{
    QTest::addColumn<std::vector<SceneItem>>("items");
    QTest::addColumn<ColliderKind>("kind");
    QTest::addColumn<World::Options>("options");
    QTest::addColumn<double>("half");
    QTest::addColumn<QString>("hash");
    const auto row = [](const char *name, const std::vector<SceneItem> &items, const char *hash,
                        ColliderKind kind = ColliderKind::Exact, const World::Options &options = {.threads = 1},
                        double half = 2) { QTest::newRow(name) << items << kind << options << half << QString(hash); };
    const SceneItem box{.model = modelOf(boxMesh(3))};
    const auto menger = modelOf(QStringLiteral("menger"), 4);
    const std::vector<SceneItem> turned{box,
                                        {.model = modelOf(QStringLiteral("tree"), 7),
                                         .worldFromModel = mapFromParts({-1, -1, 0}, {20, -30, 40}, {1, 1, 1})},
                                        {.model = modelOf(QStringLiteral("two-sets"), 3),
                                         .worldFromModel = mapFromParts({1, 0, 0.5}, {-77, 5, 111}, {0.4, 0.5, 0.6})}};
    row("a sponge", {{.model = menger}, box}, "8268ea97f58975a4", ColliderKind::Exact,
        {.shrinkRate = 0.1, .threads = 1});
    row("turned fractals", turned, "a4b477ce8e84d4fb");
    row("turned fractals, approximately", turned, "9ac2593dbd135f6a", ColliderKind::Approximate);
    row("turned fractals, written out", turned, "bc9536f656402d7b", ColliderKind::Bvh);
    row("copy after copy", {{.model = modelOf(QStringLiteral("menger"), 1)}, box}, "3964b3d1a677e8ec",
        ColliderKind::Simple);
    row("turned fractals, greedily", turned, "a006008e1905c560", ColliderKind::Greedy);
    row("turned fractals, in an octree", turned, "b51217316abafab2", ColliderKind::Octree);
    row("12 levels", {{.model = modelOf(QStringLiteral("menger"), 12)}, box}, "d46c1eb6567445d7");
    row("a pile",
        {{.model = modelOf(boxMesh(0.2)), .worldFromModel = mapFromParts({0, 2.5, 0}, {5, 0, 15}, {1, 1, 1})}},
        "8f930c46d44a2d07", ColliderKind::Exact, {.threads = 1}, 0.12);
    row("as in the dissertation", turned, "8d52810eb1a5c4de", ColliderKind::Exact,
        {.isAsInDissertation = true, .threads = 1});
}

/// By every compiler, however it optimises, and with every set of instructions: the number stands here.
void TestWorld::stepsAreTheSameBytesEverywhere()
{
    QFETCH(const std::vector<SceneItem>, items);
    QFETCH(const ColliderKind, kind);
    QFETCH(const World::Options, options);
    QFETCH(const double, half);
    QFETCH(const QString, hash);
    Ground ground(items, kind, kind == ColliderKind::Approximate ? 0.01 : 0.0);
    const std::size_t sets = withEveryInstructionSet([&] {
        World world(ground.surface, options);
        addBalls(world, 100, half);
        for (int step = 0; step < 600; ++step) {
            world.step();
        }
        QCOMPARE(QString::number(world.stateHash(), 16), hash);
    });
    QVERIFY(sets > 0);
}

void TestWorld::theHashTellsStatesApart()
{
    Ground ground(floorMesh(1));
    const auto hashOf = [&](const Ball &ball, int steps) {
        World world(ground.surface, {.threads = 1});
        world.add(ball);
        for (int step = 0; step < steps; ++step) {
            world.step();
        }
        return world.stateHash();
    };
    const Ball ball{.position = {0, 1, 0}, .radius = 0.1, .restitution = 0.5};
    const std::uint64_t hash = hashOf(ball, 3);
    QCOMPARE(hashOf(ball, 3), hash);
    QVERIFY(hashOf(ball, 4) != hash);
    for (const Ball &other :
         {Ball{.position = {0, std::nextafter(1, 2), 0}, .radius = 0.1, .restitution = 0.5},
          Ball{.position = {0, 1, 0}, .velocity = {1e-300, 0, 0}, .radius = 0.1, .restitution = 0.5},
          Ball{.position = {0, 1, 0}, .radius = 0.11, .restitution = 0.5},
          Ball{.position = {0, 1, 0}, .radius = 0.1, .restitution = 0.6}}) {
        QVERIFY(hashOf(other, 3) != hash);
    }
}

/// By other ways to search it: what rests goes on resting, what flies goes on flying.
void TestWorld::surfacesAreSwappedUnderBalls()
{
    Ground exact({{.model = modelOf(QStringLiteral("menger"), 2)}, {.model = modelOf(boxMesh(3))}});
    Ground bvh({{.model = modelOf(QStringLiteral("menger"), 2)}, {.model = modelOf(boxMesh(3))}}, ColliderKind::Bvh);
    World kept(exact.surface, {.threads = 1});
    World swapped(exact.surface, {.threads = 1});
    for (World *world : {&kept, &swapped}) {
        for (int i = 0; i < 20; ++i) {
            world->add({.position = {0.17 * i - 1.7, 2, 0.13}, .radius = 0.02, .restitution = 0.3});
        }
    }
    for (int step = 0; step < 500; ++step) {
        if (step == 40) {
            swapped.setSurface(bvh.surface);
        }
        kept.step();
        swapped.step();
    }
    int asleep = 0;
    for (std::size_t i = 0; i < 20; ++i) {
        QVERIFY(glm::distance(kept.balls()[i].position, swapped.balls()[i].position) < 1e-4);
        asleep += kept.balls()[i].isAsleep ? 1 : 0;
    }
    QVERIFY(asleep > 5);
    swapped.setSurface(exact.surface);
    QVERIFY(std::ranges::none_of(swapped.balls(), &BallState::isAsleep));
    swapped.step();
    swapped.step();
    for (std::size_t i = 0; i < 20; ++i) {
        QVERIFY(!kept.balls()[i].isAsleep
                || glm::distance(kept.balls()[i].position, swapped.balls()[i].position) < 1e-5);
    }
}

void TestWorld::eachColliderKeepsItsPromise_data()
{
    addKinds();
}

/// Those that prove something never let a ball in; the others may, and come to an end all the same.
void TestWorld::eachColliderKeepsItsPromise()
{
    QFETCH(const ColliderKind, kind);
    const double excess = kind == ColliderKind::Approximate ? 0.01 : 0.0;
    const std::vector<SceneItem> items{{.model = modelOf(QStringLiteral("tree"), 3)}, {.model = modelOf(boxMesh(3))}};
    Ground ground(items, kind, excess);
    Ground truth(items);
    World world(ground.surface, {.threads = 1});
    addBalls(world, 30, 1.5);
    for (int step = 0; step < 300; ++step) {
        world.step();
        if (ground.surface.isProved) {
            for (const BallState &ball : world.balls()) {
                QVERIFY(truth.distance(ball.position) >= ball.radius * (1 - 1e-3));
            }
        }
    }
    QCOMPARE(world.lostSteps(), std::uint64_t{0});
}

void TestWorld::ballsShrink()
{
    Ground ground(floorMesh(1));
    World world(ground.surface, {.shrinkRate = 30, .threads = 1});
    world.add({.position = {0, 0.5, 0}, .radius = 0.2, .restitution = 0.5});
    for (int step = 1; step <= 480; ++step) {
        world.step();
        const double share = std::max(1e-9, std::exp(-30 * step / 240.0));
        QVERIFY(std::abs(world.balls()[0].radius / (0.2 * share) - 1) < 1e-12);
        QVERIFY(ground.distance(world.balls()[0].position) >= world.balls()[0].radius * (1 - 1e-3));
    }
    QCOMPARE(world.balls()[0].radius, 0.2e-9);
    QCOMPARE(world.lostSteps(), std::uint64_t{0});
}

/// Between two boxes, once it is as narrow as the gap.
void TestWorld::aShrinkingBallFallsThrough()
{
    const auto model = modelOf(boxMesh(1));
    Ground ground({{.model = model, .worldFromModel = mapFromParts({-1.05, 0, 0}, {}, {1, 1, 1})},
                   {.model = model, .worldFromModel = mapFromParts({1.05, 0, 0}, {}, {1, 1, 1})}});
    World world(ground.surface, {.shrinkRate = 1, .threads = 1});
    world.add({.position = {0, 1.3, 0}, .radius = 0.2, .restitution = 0});
    double radiusBelow = 0;
    for (int step = 0; step < 720; ++step) {
        world.step();
        const BallState &ball = world.balls()[0];
        QVERIFY(ground.distance(ball.position) >= ball.radius * (1 - 1e-3));
        if (ball.position.y > 1) {
            radiusBelow = ball.radius;
        }
    }
    QVERIFY(world.balls()[0].position.y < -1);
    QVERIFY2(radiusBelow > 0.049 && radiusBelow < 0.052, qPrintable(QString::number(radiusBelow)));
}

/// Dropped from 10 or more with e = 1, ten bounces at 60 steps a second: a tenth or so.
void TestWorld::asInTheDissertationEnergyIsLost()
{
    Ground ground(floorMesh(1));
    Laws laws;
    laws.timeStep = 1.0 / 60.0;
    double lost = 0;
    constexpr int heights = 200;
    for (int i = 0; i < heights; ++i) {
        World world(ground.surface, {.laws = laws, .isAsInDissertation = true, .threads = 1});
        const double height = 10 + 3.0 * i / heights;
        world.add({.position = {0.1, 0.5 + height, 0.2}, .radius = 0.5, .restitution = 1});
        unsigned bounces = 0;
        for (int step = 0; step < 10'000 && bounces < 10; ++step) {
            world.step();
            bounces += world.reports()[0].contacts;
        }
        QCOMPARE(bounces, 10u);
        const BallState &ball = world.balls()[0];
        lost += 1 - (energyOf(ball, laws) - 9.8 * 0.5) / (9.8 * height);
    }
    lost /= heights;
    QVERIFY2(lost > 0.05 && lost < 0.2, qPrintable(QString::number(lost)));
}

/// With a probability of 1 - 2·r/(v·dt): a ball is turned back where a step ends within the radius of the floor, on either
/// side.
void TestWorld::asInTheDissertationBallsTunnel()
{
    Ground ground(floorMesh(10));
    Laws laws;
    laws.gravity = glm::dvec3(0);
    World world(ground.surface, {.laws = laws, .isAsInDissertation = true, .threads = 1});
    World ours(ground.surface, {.laws = laws, .threads = 1});
    constexpr int count = 4000;
    const double radius = 0.01;
    const double way = 10 * radius;
    std::mt19937_64 random(10);
    for (int i = 0; i < count; ++i) {
        const Ball ball{.position = {uniform(random, -1, 1), uniform(random, 1, 2), uniform(random, -1, 1)},
                        .velocity = {0, -way / laws.timeStep, 0},
                        .radius = radius,
                        .restitution = 1};
        world.add(ball);
        ours.add(ball);
    }
    for (int step = 0; step < 40; ++step) {
        world.step();
        ours.step();
    }
    const auto through = [](const World &one) {
        return std::ranges::count_if(one.balls(), [](const BallState &ball) { return ball.position.y < 0; });
    };
    const double share = static_cast<double>(through(world)) / count;
    QVERIFY2(std::abs(share - 0.8) < 0.02, qPrintable(QString::number(share)));
    QCOMPARE(through(ours), 0);
}

}

ROMANESCO_TEST(romanesco::test::TestWorld)

#include "testworld.moc"
