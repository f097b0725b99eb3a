// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "core/physics/livesimulation.h"

#include <atomic>
#include <future>

#include <QTest>

#include "tests/core/physics/grounds.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

using Frame = LiveSimulation::Frame;

/// Waits, even on a machine that has much else to do.
template<typename Predicate>
bool comesTo(const LiveSimulation &live, Predicate isMeant)
{
    for (int i = 0; i < 60'000; ++i) {
        if (isMeant(*live.newest())) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
}

/// A box, and a ball above its floor.
std::shared_ptr<const Scene> ballInABox(double height, double floor = 1.0)
{
    const auto ball = modelOf(boxMesh(0.1));
    const AffineMap place{glm::dmat3(1.0), {0.0, height, 0.0}};
    return sceneOf(
        {{.model = modelOf(boxMesh(floor))},
         {.model = ball, .worldFromModel = place, .kind = SceneDescription::Kind::Ball, .restitution = 0.5}});
}

Recording recordingOf(LiveSimulation &live)
{
    std::promise<std::expected<Recording, std::string>> promise;
    live.record([&](std::expected<Recording, std::string> told) { promise.set_value(std::move(told)); });
    return promise.get_future().get().value_or(Recording{});
}

/// Steps one by one.
void makeSteps(LiveSimulation &live, int count)
{
    for (int i = 0; i < count; ++i) {
        live.step();
    }
}

Ball ballAt(const glm::dvec3 &position)
{
    Ball ball;
    ball.position = position;
    ball.radius = 0.05;
    ball.restitution = 0.3;
    return ball;
}

}

class TestLiveSimulation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingIsMadeBeforeItIsNeeded();
    void stepsAreThoseOfASimulation();
    void timeIsTheSumOfItsSteps();
    void itKeepsPaceWithTheClock();
    void itGoesSlowerWhereItCannot();
    void aSceneComesUnderTheBalls();
    void ofManyScenesTheLastOneCounts();
    void resetIsTheStart();
    void ballsComeAndGo();
    void whatIsDoneIsRecordedAndReplayed();
    void noRecordingOfAnEditedScene();
    void aRecordingOfAnotherSceneIsRefused();
    void whatCannotBeIsTold();
    void itEndsWhileItPlays();
};

void TestLiveSimulation::nothingIsMadeBeforeItIsNeeded()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.setSpeed(2.0);
    live.setScene(ballInABox(0.5));
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    QVERIFY(!live.newest()->isStarted);
    QVERIFY(live.newest()->balls.empty());
    live.step();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 1U; }));
    QCOMPARE(live.newest()->balls.size(), 1U);
    // of the scene that came last, not of the first
    QCOMPARE(live.newest()->balls[0].before.y, 0.5);
}

void TestLiveSimulation::stepsAreThoseOfASimulation()
{
    const auto scene = ballInABox(0.0);
    auto plain = Simulation::start(scene, {}, {}).value();
    LiveSimulation live([] { });
    live.startScene(scene);
    for (int i = 1; i <= 600; ++i) {
        plain.step();
        live.step();
    }
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 600U; }));
    const BallState &ball = plain.world().balls()[0];
    const auto frame = live.newest();
    QVERIFY(frame->balls[0].after == ball.position);
    QCOMPARE(frame->balls[0].radius, ball.radius);
    QCOMPARE(frame->balls[0].contacts, plain.world().reports()[0].contacts);
    QCOMPARE(recordingOf(live).endHash, plain.world().stateHash());
    // it came to rest on the floor: m g h is all that is left
    QVERIFY(frame->balls[0].isAsleep);
    const double mass = 4.0 / 3.0 * std::acos(-1.0) * std::pow(ball.radius, 3);
    QVERIFY(std::abs(frame->energy - mass * 9.8 * ball.position.y) < 1e-12);
}

void TestLiveSimulation::timeIsTheSumOfItsSteps()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    makeSteps(live, 3);
    World::Options rules;
    rules.laws.timeStep = 1.0 / 30.0;
    live.setRules(rules);
    makeSteps(live, 2);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 5U; }));
    QVERIFY(std::abs(live.newest()->seconds - (3.0 / 240.0 + 2.0 / 30.0)) < 1e-12);
    live.reset();
    live.step();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 1U; }));
    QCOMPARE(live.newest()->seconds, 1.0 / 30.0);
}

void TestLiveSimulation::itKeepsPaceWithTheClock()
{
    std::atomic<int> told = 0;
    LiveSimulation live([&] { ++told; });
    live.startScene(ballInABox(0.0));
    live.setSpeed(0.5);
    live.play();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.isPlaying; }));
    const auto from = LiveSimulation::Clock::now();
    const std::uint64_t first = live.newest()->stepCount;
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount >= first + 120; }));
    // no faster than it should: 120 steps of 1/240 s at half the speed
    const std::chrono::duration<double> gone = LiveSimulation::Clock::now() - from;
    QVERIFY(gone.count() > 0.9);
    const auto slow = live.newest();
    QVERIFY(slow->figures.realTimeFactor > 0.0 && slow->figures.realTimeFactor < 0.6);
    QCOMPARE(slow->way.count(), 2.0 / 240.0);
    QVERIFY(told > 10);
    live.pause();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.isPlaying; }));
    QCOMPARE(live.newest()->figures.realTimeFactor, 0.0);
}

/// A speed that no machine has: it does what it can, and goes on answering.
void TestLiveSimulation::itGoesSlowerWhereItCannot()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.setSpeed(1e9);
    live.play();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.figures.realTimeFactor > 0.0; }));
    QVERIFY(live.newest()->figures.realTimeFactor < 1e8);
    live.pause();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.isPlaying; }));
}

void TestLiveSimulation::aSceneComesUnderTheBalls()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    makeSteps(live, 600);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 600U; }));
    const double high = live.newest()->balls[0].after.y;
    // the floor falls away
    live.setScene(ballInABox(0.5, 2.0));
    makeSteps(live, 600);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 1200U; }));
    QVERIFY(std::abs(live.newest()->balls[0].after.y - (high - 1.0)) < 1e-3);
    live.setScene(nullptr);
    live.play();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.remark.empty(); }));
    QVERIFY(!live.newest()->isPlaying);
}

void TestLiveSimulation::ofManyScenesTheLastOneCounts()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.step();
    for (int i = 0; i < 100; ++i) {
        live.setScene(ballInABox(0.0, i == 99 ? 1.5 : 1.0));
    }
    makeSteps(live, 400);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 401U; }));
    QVERIFY(live.newest()->balls[0].after.y < -1.2);
    QCOMPARE(live.newest()->remark, std::string());
}

void TestLiveSimulation::resetIsTheStart()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.25));
    live.drop({ballAt({0.3, 0.0, 0.0})});
    live.play();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount > 5; }));
    live.reset();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.isStarted; }));
    QVERIFY(!live.newest()->isPlaying);
    live.step();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.balls.size() == 1U; }));
    QCOMPARE(live.newest()->balls[0].before.y, 0.25);
}

void TestLiveSimulation::ballsComeAndGo()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.drop({ballAt({0.3, 0.0, 0.0}), ballAt({-0.3, 0.0, 0.0})}, 5);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.balls.size() == 3U; }));
    QCOMPARE(live.newest()->balls[0].mark, 0U);
    QCOMPARE(live.newest()->balls[2].mark, 5U);
    live.remove(1);
    live.remove(77);
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.balls.size() == 2U; }));
    QCOMPARE(live.newest()->balls[1].number, 2U);
    QCOMPARE(live.newest()->balls[1].mark, 5U);
    QCOMPARE(live.newest()->balls[0].after.x, 0.0);
    QCOMPARE(live.newest()->balls[1].after.x, -0.3);
    live.drop({ballAt({0.0, 0.5, 0.0})});
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.balls.size() == 3U; }));
    QCOMPARE(live.newest()->balls[2].number, 3U);
    QCOMPARE(live.newest()->stepCount, 0U);
}

void TestLiveSimulation::whatIsDoneIsRecordedAndReplayed()
{
    const auto scene = ballInABox(0.0);
    LiveSimulation live([] { });
    live.startScene(scene);
    makeSteps(live, 20);
    live.drop({ballAt({0.3, 0.0, 0.0}), ballAt({-0.3, 0.1, 0.0})});
    makeSteps(live, 20);
    World::Options rules;
    rules.laws.gravity = {1.0, 2.0, 3.0};
    rules.shrinkRate = 0.5;
    rules.laws.isGravityInRadii = true;
    live.setRules(rules);
    makeSteps(live, 20);
    live.setCollider({ColliderKind::Bvh, 0.0});
    live.remove(0);
    makeSteps(live, 20);
    const Recording recording = recordingOf(live);
    QCOMPARE(recording.inputs.size(), 5U);
    QCOMPARE(recording.steps, 80U);

    // through a file, by the command line's way
    const auto read = recordingFromText(textOf(recording));
    QVERIFY2(read, read ? "" : read.error().c_str());
    auto plain = Simulation::start(scene, read->world, read->collider).value();
    auto input = read->inputs.begin();
    for (std::uint64_t step = 0; step < read->steps; ++step) {
        for (; input != read->inputs.end() && input->step == step; ++input) {
            QVERIFY(plain.apply(*input));
        }
        plain.step();
    }
    QCOMPARE(plain.world().stateHash(), recording.endHash);

    live.setSpeed(1000.0);
    live.replay(*read);
    QVERIFY(comesTo(
        live, [&](const Frame &frame) { return QByteArray::fromStdString(frame.remark).contains("the same state"); }));
    QVERIFY(!live.newest()->isPlaying);
    QCOMPARE(live.newest()->stepCount, 80U);

    Recording wrong = *read;
    wrong.endHash ^= 1U;
    live.replay(wrong);
    QVERIFY(comesTo(
        live, [&](const Frame &frame) { return QByteArray::fromStdString(frame.remark).contains("another state"); }));
}

void TestLiveSimulation::noRecordingOfAnEditedScene()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.step();
    live.setScene(ballInABox(0.0, 1.5));
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.isRecorded; }));
    std::promise<std::expected<Recording, std::string>> promise;
    live.record([&](std::expected<Recording, std::string> told) { promise.set_value(std::move(told)); });
    const auto told = promise.get_future().get();
    QVERIFY(!told);
    QVERIFY(QByteArray::fromStdString(told.error()).contains("edited"));
    live.reset();
    QCOMPARE(recordingOf(live).steps, 0U);
}

void TestLiveSimulation::aRecordingOfAnotherSceneIsRefused()
{
    LiveSimulation live([] { });
    live.startScene(ballInABox(0.0));
    live.step();
    const Recording recording = recordingOf(live);
    live.startScene(ballInABox(0.125));
    live.replay(recording);
    QVERIFY(comesTo(live, [&](const Frame &frame) {
        return QByteArray::fromStdString(frame.remark).contains("not those of the recording");
    }));
    QVERIFY(!live.newest()->isPlaying);
}

/// What a collider cannot do leaves the one there is.
void TestLiveSimulation::whatCannotBeIsTold()
{
    const auto deep = sceneOf({{.model = modelOf(QStringLiteral("menger"), 30)}});
    LiveSimulation live([] { });
    live.play();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.remark.empty(); }));
    live.startScene(deep);
    live.drop({ballAt({0.0, 3.0, 0.0})});
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.balls.size() == 1U; }));
    QVERIFY(live.newest()->remark.empty());
    live.setCollider({ColliderKind::Bvh, 0.0});
    QVERIFY(comesTo(live, [&](const Frame &frame) { return !frame.remark.empty(); }));
    live.setCollider({ColliderKind::Approximate, 1e-3});
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.remark.empty(); }));
    live.step();
    QVERIFY(comesTo(live, [&](const Frame &frame) { return frame.stepCount == 1U; }));
    QVERIFY(live.newest()->balls[0].after.y < 3.0);
}

void TestLiveSimulation::itEndsWhileItPlays()
{
    for (int i = 0; i < 20; ++i) {
        LiveSimulation live([] { });
        live.startScene(ballInABox(0.0));
        live.play();
        live.drop({ballAt({0.3, 0.0, 0.0})});
        live.setScene(ballInABox(0.1));
    }
}

}

ROMANESCO_TEST(romanesco::test::TestLiveSimulation)

#include "testlivesimulation.moc"
