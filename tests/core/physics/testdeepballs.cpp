// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <format>

#include <QTest>

#include <glm/vector_relational.hpp>

#include "core/physics/simulation.h"
#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// Gravity that suits every size.
World::Options inRadii()
{
    World::Options options;
    options.laws.gravity = {0.0, -40.0, 0.0};
    options.laws.isGravityInRadii = true;
    options.threads = 2;
    return options;
}

/// A sponge of four levels, so many levels down in one of more; the same at every depth.
struct Sponge {
    std::shared_ptr<const Scene> scene;
    ScenePlace place{0, {}};

    explicit Sponge(std::size_t levels)
        : scene(sceneOf({{.model = modelOf(QStringLiteral("menger"), levels + 4)}}))
    {
        // at the bottom, with nothing above it
        const auto &maps = scene->items[0].model->graph.set(0).maps;
        const auto isWanted = [](const AffineMap &map) {
            return glm::distance(map.translation, glm::dvec3(0, -1, 1)) < 1e-9;
        };
        const auto map = std::ranges::find_if(maps, isWanted) - maps.begin();
        place.steps.assign(levels, Step{0, static_cast<std::uint32_t>(map)});
    }

    [[nodiscard]] Simulation start(const World::Options &options) const
    {
        return Simulation::start(scene, options, {}).value();
    }
};

/// Above a sponge of size 3, in the free.
std::vector<Ball> ballsOver(int count)
{
    std::mt19937_64 random(seed(3));
    std::vector<Ball> balls;
    for (int i = 0; i < count; ++i) {
        Ball ball;
        ball.radius = uniform(random, 0.01, 0.05);
        ball.position = {uniform(random, -1.4, 1.4), uniform(random, 1.56, 2), uniform(random, -1.4, 1.4)};
        ball.restitution = uniform(random, 0.0, 0.9);
        balls.push_back(ball);
    }
    return balls;
}

double overlapOf(const World &world, std::size_t number)
{
    const BallState &ball = world.balls()[number];
    Hit hit;
    world.surface(ball.place)->collider->search()->closest({.p = ball.position, .radius = ball.radius}, hit);
    return hit.isFound() ? 1.0 - hit.distance / ball.radius : 0.0;
}

}

class TestDeepBalls : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theSameDropIsTheSameAtEveryDepth_data();
    void theSameDropIsTheSameAtEveryDepth();
    void gravityIsThatOfTheWorld();
    void gravityInRadiiSuitsEachBall();
    void aTinyBallOfASceneIsCountedFromNearby();
    void whatLeavesAPlaceIsHeldByTheScene();
    void recordingsHoldPlaces();
    void editsTakePlacesAlong();
    void placesThatAreNotThereAreTold();
};

void TestDeepBalls::theSameDropIsTheSameAtEveryDepth_data()
{
    QTest::addColumn<std::size_t>("levels");
    for (const std::size_t levels : {4, 10, 20, 63, 200, 1000}) {
        QTest::addRow("1e-%.0f of the scene", std::floor(double(levels) * std::log10(3.0))) << levels;
    }
}

/// As in world coordinates, three levels down, where those are exact.
void TestDeepBalls::theSameDropIsTheSameAtEveryDepth()
{
    QFETCH(const std::size_t, levels);
    const Sponge sponge(3);
    auto shallow = sponge.start(inRadii());
    const auto origin = Anchor::at(sponge.scene, sponge.place)->surroundings();
    const double unit = std::exp2(origin->unitExponent);
    const Sponge deep(levels);
    auto there = deep.start(inRadii());
    for (const Ball &ball : ballsOver(40)) {
        QVERIFY(there.apply({0, Recording::Drop{ball, deep.place}}));
        Ball inWorld = ball;
        inWorld.position = origin->worldFromHere(ball.position);
        inWorld.radius *= unit;
        QVERIFY(shallow.apply({0, Recording::Drop{inWorld}}));
    }
    double farthest = 0.0;
    double deepest = 0.0;
    for (int step = 0; step < 480; ++step) {
        shallow.step();
        there.step();
        for (std::size_t i = 0; i < 40; ++i) {
            const BallState &a = shallow.world().balls()[i];
            const BallState &b = there.world().balls()[i];
            QVERIFY(a.place == 0 && b.place > 0);
            farthest = std::max(farthest, glm::distance((a.position - origin->origin) / unit, b.position) / b.radius);
            deepest = std::max(deepest, overlapOf(there.world(), i));
        }
    }
    qInfo("apart by %.2g radii at most, %.2g radii deep", farthest, deepest);
    QVERIFY(deepest <= 1e-3);
    // bounces begin anywhere in the skin of 1e-4 radii
    QVERIFY(farthest <= 1e-2);
}

/// In a place of its own a ball falls as it does in the world.
void TestDeepBalls::gravityIsThatOfTheWorld()
{
    const Sponge sponge(3);
    const auto origin = Anchor::at(sponge.scene, sponge.place)->surroundings();
    const double unit = std::exp2(origin->unitExponent);
    World::Options options;
    options.laws.gravity = {0.02, -0.05, 0.01};
    auto there = sponge.start(options);
    auto inWorld = sponge.start(options);
    for (const Ball &ball : ballsOver(10)) {
        QVERIFY(there.apply({0, Recording::Drop{ball, sponge.place}}));
        QVERIFY(inWorld.apply({0, Recording::Drop{romanesco::inWorld(ball, origin.get())}}));
    }
    for (int step = 0; step < 480; ++step) {
        there.step();
        inWorld.step();
        for (std::size_t i = 0; i < 10; ++i) {
            const Ball ball = romanesco::inWorld(there.world().balls()[i], origin.get());
            const BallState &expected = inWorld.world().balls()[i];
            QVERIFY(glm::distance(ball.position, expected.position) < 1e-2 * ball.radius);
        }
    }
    QVERIFY(there.world().balls()[0].position.y < 1.6 && unit < 0.04);
}

/// Heaps of all sizes come down as one another, measured in radii: they fall, hit, slide and fall asleep alike.
void TestDeepBalls::gravityInRadiiSuitsEachBall()
{
    std::vector<std::vector<BallState>> ends;
    for (const double size : {1.0, 1.0 / 1024.0, 64.0}) {
        Ground ground(boxMesh(4.0 * size));
        World world(ground.surface, inRadii());
        std::mt19937_64 random(seed(2));
        for (int i = 0; i < 24; ++i) {
            const glm::dvec3 cell(i % 3 - 1, i / 9 - 1, i / 3 % 3 - 1);
            const double radius = i % 2 ? 0.8 : 1.1;
            world.add({.position = size * (2.6 * cell + randomPoint(random, 0.1)),
                       .radius = size * radius,
                       .restitution = 0.3});
        }
        bool hasPiled = false;
        for (int step = 0; step < 2'000; ++step) {
            world.step();
            hasPiled = hasPiled || std::ranges::any_of(world.balls(), &BallState::isPiled);
        }
        QVERIFY(hasPiled);
        std::vector<BallState> end(world.balls().begin(), world.balls().end());
        for (BallState &ball : end) {
            ball.position /= size;
        }
        ends.push_back(std::move(end));
    }
    for (const auto &end : ends) {
        for (std::size_t i = 0; i < end.size(); ++i) {
            QVERIFY(glm::distance(end[i].position, ends[0][i].position) < 1e-9);
            QCOMPARE(end[i].isAsleep, ends[0][i].isAsleep);
            QCOMPARE(end[i].calmSteps, ends[0][i].calmSteps);
        }
    }
}

/// It lands on what is there: as one of usual size does in a place of its own.
void TestDeepBalls::aTinyBallOfASceneIsCountedFromNearby()
{
    const Sponge sponge(40);
    std::vector<SceneItem> items = sponge.scene->items;
    const auto origin = Anchor::at(sponge.scene, sponge.place)->surroundings();
    const double unit = std::exp2(origin->unitExponent);
    // where world coordinates are 1e-16, it is 1e-21 across: its place rounds to some node's
    items.push_back({.model = modelOf(boxMesh(1)),
                     .worldFromModel = {glm::dmat3(1e-2 * unit), origin->worldFromHere({0.0, 1.6, 0.0})},
                     .kind = SceneDescription::Kind::Ball,
                     .restitution = 0.3});
    World::Options options = inRadii();
    options.laws.gravity = {0.0, 4e3, -4e3}; // into the edge
    auto simulation = Simulation::start(sceneOf(items), options, {}).value();
    QVERIFY(simulation.world().balls()[0].place > 0);
    QVERIFY(simulation.world().balls()[0].radius > 1e-8);
    bool hasTouched = false;
    for (int step = 0; step < 2'000; ++step) {
        simulation.step();
        QVERIFY(overlapOf(simulation.world(), 0) <= 1e-3);
        hasTouched = hasTouched || simulation.world().reports()[0].contacts > 0;
    }
    QVERIFY(hasTouched);
    QVERIFY(simulation.places().surroundings(simulation.world().balls()[0].place)->path.size() > 20);
}

/// Out of a place of 1e-30, 1e9 of them a step and more, until what is round it all stops it.
void TestDeepBalls::whatLeavesAPlaceIsHeldByTheScene()
{
    const Sponge sponge(63);
    std::vector<SceneItem> items = sponge.scene->items;
    items.push_back({.model = modelOf(boxMesh(20))});
    World::Options options;
    options.laws.gravity = glm::dvec3(0.0);
    options.shrinkRate = 0.1;
    options.areSolid = false;
    auto simulation = Simulation::start(sceneOf(items), options, {}).value();
    std::vector<double> speeds;
    const auto unit = std::exp2(Anchor::at(sceneOf(items), sponge.place)->surroundings()->unitExponent);
    std::mt19937_64 random(seed(8));
    constexpr int count = 60;
    for (int i = 0; i < count; ++i) {
        // seen from outside, below and beside the whole, it is free
        const glm::dvec3 out = glm::normalize(glm::dvec3(uniform(random, -0.4, 0.4), -1.0, uniform(random, 1.0, 2.0)));
        const double speed = std::pow(10.0, uniform(random, 0.0, 4.0));
        speeds.push_back(speed);
        Ball ball{glm::dvec3(0.0, -1.7, 1.7), speed / unit * out, 0.01, 1.0};
        QVERIFY(simulation.apply({0, Recording::Drop{ball, sponge.place}}));
        QVERIFY(simulation.world().balls().back().place > 0 || speed > 1.0);
    }
    for (int step = 0; step < 240; ++step) {
        simulation.step();
        for (const BallState &ball : simulation.world().balls()) {
            const auto &here = simulation.places().surroundings(ball.place);
            const glm::dvec3 position = here ? here->worldFromHere(ball.position) : ball.position;
            QVERIFY(glm::all(glm::lessThan(glm::abs(position), glm::dvec3(20.0 + 1e-9))));
        }
    }
    int whole = 0;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        const BallState &state = simulation.world().balls()[i];
        const auto &here = simulation.places().surroundings(state.place);
        QVERIFY(!here || here->unitExponent > -30.0);
        const Ball ball = inWorld(state, here.get());
        const double share = glm::length(ball.velocity) / speeds[i];
        QVERIFY(share < 1.0 + 1e-9);
        whole += share > 1.0 - 1e-6 ? 1 : 0;
        QVERIFY(std::abs(ball.radius / (0.01 * unit * std::exp(-0.1)) - 1.0) < 1e-9);
    }
    // where it goes so fast the skin of so small a ball is rounding: what grazes is taken for sliding
    qInfo("%d of %d keep their speed", whole, count);
    QVERIFY(whole >= count / 2);
}

void TestDeepBalls::recordingsHoldPlaces()
{
    const Sponge sponge(63);
    World::Options options = inRadii();
    options.shrinkRate = 0.5;
    auto first = sponge.start(options);
    const auto balls = ballsOver(20);
    for (std::size_t i = 0; i < balls.size(); ++i) {
        QVERIFY(first.apply({0, Recording::Drop{balls[i], i % 3 ? std::optional(sponge.place) : std::nullopt}}));
    }
    for (int step = 0; step < 60; ++step) {
        first.step();
    }
    const std::string text = textOf(first.recording());
    QVERIFY2(text.contains(std::format(" in 0: 0.{}*63\n", sponge.place.steps[0].map)), text.c_str());
    QVERIFY(text.contains(" radii\n"));
    const Recording read = recordingFromText(text).value();
    auto again = sponge.start(read.world);
    QCOMPARE(again.world().stateHash(), read.startHash);
    for (const Recording::Input &input : read.inputs) {
        QVERIFY(again.apply(input));
    }
    for (int step = 0; step < 60; ++step) {
        again.step();
    }
    QCOMPARE(again.world().stateHash(), read.endHash);
    for (const char *wrong : {"in", "in 0", "in 0: 0", "in 0: 0.1*", "in x: 0.1", "of 0: 0.1", "in 0: 0.1*200000"}) {
        const std::string line = std::format("drop 0 0 0 0 0 0 1 1 {}\n", wrong);
        QVERIFY2(!recordingFromText("romanesco recording 1\nat 0 " + line + "end 0 0\n"), wrong);
    }
}

/// As many levels as there are.
void TestDeepBalls::editsTakePlacesAlong()
{
    const Sponge sponge(30);
    auto simulation = sponge.start(inRadii());
    Ball ball;
    ball.radius = 0.01;
    ball.position = {0.3, 1.7, 0.2};
    QVERIFY(simulation.apply({0, Recording::Drop{ball, sponge.place}}));
    const auto inWorld = [&] {
        const BallState &now = simulation.world().balls()[0];
        const auto &here = simulation.places().surroundings(now.place);
        return here ? here->worldFromHere(now.position) : now.position;
    };
    const glm::dvec3 before = inWorld();
    QVERIFY(simulation.setScene(Sponge(31).scene));
    QVERIFY(simulation.world().balls()[0].position == ball.position);
    QVERIFY(simulation.setScene(Sponge(8).scene));
    QVERIFY(glm::distance(inWorld(), before) < 1e-14);
    QVERIFY(std::abs(simulation.world().balls()[0].radius / 0.01 / std::pow(3.0, 12 - 30) - 1.0) < 1e-9);
    QVERIFY(simulation.setScene(sceneOf({{.model = modelOf(boxMesh(20))}})));
    QVERIFY(glm::distance(inWorld(), before) < 1e-14);
    simulation.step();
    QVERIFY(simulation.world().balls()[0].position.y < before.y + 1e-14);
}

void TestDeepBalls::placesThatAreNotThereAreTold()
{
    const Sponge sponge(3);
    auto simulation = sponge.start(inRadii());
    const auto refused = simulation.apply({0, Recording::Drop{Ball(), ScenePlace{0, {{0, 3}, {0, 77}}}}});
    QVERIFY(!refused);
    QCOMPARE(refused.error(), std::string("the scene has no place 0: 0.3 0.77 "));
    QVERIFY(!simulation.apply({0, Recording::Drop{Ball(), ScenePlace{5}}}));
    QVERIFY(simulation.world().balls().empty());
    QVERIFY(simulation.recording().inputs.empty());
    simulation.step();
}

}

ROMANESCO_TEST(romanesco::test::TestDeepBalls)

#include "testdeepballs.moc"
