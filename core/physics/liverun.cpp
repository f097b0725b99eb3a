// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "liverun.h"

#include <algorithm>
#include <utility>

namespace romanesco {

namespace {

using namespace std::chrono_literals;
using Clock = LiveSimulation::Clock;
using Seconds = std::chrono::duration<double>;

/// What is behind by more is not caught up with.
constexpr auto mostDebt = 50ms;

}

void LiveRun::setScene(const std::shared_ptr<const Scene> &scene, const std::stop_token &stop)
{
    m_scene = scene;
    m_replay.reset();
    if (!m_scene) {
        pause();
    } else if (m_simulation) {
        m_remark.clear();
        if (const auto set = m_simulation->setScene(m_scene, stop); !set && !stop.stop_requested()) {
            say(set.error());
        }
    }
}

void LiveRun::startScene(std::shared_ptr<const Scene> scene)
{
    m_scene = std::move(scene);
    reset();
}

void LiveRun::setRules(const World::Options &world)
{
    m_world = world;
    m_replay.reset();
    if (m_simulation) {
        apply(world);
    }
}

void LiveRun::setCollider(const SceneCollider::Options &collider)
{
    m_replay.reset();
    if (m_simulation && !apply(collider)) {
        return;
    }
    m_collider = collider;
}

void LiveRun::setSpeed(double speed)
{
    m_speed = speed;
    m_due = Clock::now();
}

void LiveRun::play()
{
    m_isPlaying = start();
    m_due = Clock::now();
    m_meter.begin();
}

void LiveRun::pause()
{
    m_isPlaying = false;
    m_meter.end();
}

void LiveRun::step()
{
    pause();
    if (start()) {
        stepOnce();
    }
}

void LiveRun::reset()
{
    pause();
    m_simulation.reset();
    m_replay.reset();
    m_remark.clear();
    m_numbers.clear();
    m_marks.clear();
    m_meter.clear();
}

void LiveRun::drop(const std::vector<Ball> &balls, unsigned mark, const std::optional<ScenePlace> &place)
{
    m_replay.reset();
    if (!start()) {
        return;
    }
    for (const Ball &ball : balls) {
        if (apply(Recording::Drop{ball, place})) {
            add(mark);
        }
    }
}

void LiveRun::remove(std::uint64_t number)
{
    const auto found = std::ranges::find(m_numbers, number);
    if (found == m_numbers.end()) {
        return;
    }
    m_replay.reset();
    const auto at = found - m_numbers.begin();
    if (apply(Recording::Removal{static_cast<std::size_t>(at)})) {
        forget(at);
    }
}

void LiveRun::record(const std::function<void(std::expected<Recording, std::string>)> &told)
{
    if (!start()) {
        told(std::unexpected(m_remark));
    } else if (!m_simulation->isRecorded()) {
        told(std::unexpected("The scene was edited while balls moved. Reset, and what follows can be recorded."));
    } else {
        told(m_simulation->recording());
    }
}

void LiveRun::replay(Recording recording)
{
    reset();
    const World::Options world = std::exchange(m_world, recording.world);
    const SceneCollider::Options collider = std::exchange(m_collider, recording.collider);
    m_isPlaying = start();
    m_world = world;
    m_collider = collider;
    if (!m_isPlaying) {
        return;
    }
    if (m_simulation->world().stateHash() != recording.startHash) {
        reset();
        say("The balls of this scene are not those of the recording.");
        return;
    }
    m_replay.emplace(Replay{std::move(recording)});
    m_due = Clock::now();
    m_meter.begin();
}

void LiveRun::advance()
{
    const auto way = std::chrono::duration_cast<Clock::duration>(Seconds(wayOfStep()));
    if (Clock::now() - m_due > mostDebt) {
        m_due = Clock::now();
    }
    followReplay();
    if (m_isPlaying) {
        stepOnce();
        m_due += way;
    }
}

void LiveRun::followReplay()
{
    if (!m_replay) {
        return;
    }
    const Recording &recording = m_replay->recording;
    const std::uint64_t step = m_simulation->world().stepCount();
    for (; m_replay->next < recording.inputs.size() && recording.inputs[m_replay->next].step == step;
         ++m_replay->next) {
        applyReplayed(recording.inputs[m_replay->next]);
    }
    if (step >= recording.steps) {
        say(m_simulation->world().stateHash() == recording.endHash
                ? "The recording came to the same state as when it was made."
                : "The recording came to another state than when it was made.");
        m_replay.reset();
        pause();
    }
}

void LiveRun::applyReplayed(const Recording::Input &input)
{
    if (const auto applied = m_simulation->apply(input, m_stop); !applied) {
        say(applied.error());
        return;
    }
    if (std::holds_alternative<Recording::Drop>(input.what)) {
        add(0);
    } else if (const auto *removal = std::get_if<Recording::Removal>(&input.what)) {
        forget(static_cast<std::ptrdiff_t>(removal->ball));
    }
}

void LiveRun::add(unsigned mark)
{
    m_numbers.push_back(m_nextNumber++);
    m_marks.push_back(mark);
}

void LiveRun::forget(std::ptrdiff_t at)
{
    m_numbers.erase(m_numbers.begin() + at);
    m_marks.erase(m_marks.begin() + at);
}

/// Whether there is a simulation, now at the latest.
bool LiveRun::start()
{
    if (!m_scene) {
        say("There is no scene yet.");
        return false;
    }
    if (m_simulation) {
        return true;
    }
    auto made = Simulation::start(m_scene, m_world, m_collider, m_stop);
    if (!made) {
        say(made.error());
        return false;
    }
    m_simulation.emplace(std::move(*made));
    m_seconds = 0.0;
    m_remark.clear();
    m_nextNumber = 0;
    m_ownBalls = m_simulation->world().balls().size();
    for (std::size_t i = 0; i < m_ownBalls; ++i) {
        add(0);
    }
    return true;
}

template<typename What>
bool LiveRun::apply(const What &what)
{
    m_remark.clear();
    const auto applied = m_simulation->apply({0, what}, m_stop);
    if (!applied) {
        say(applied.error());
    }
    return applied.has_value();
}

void LiveRun::stepOnce()
{
    const Clock::time_point begun = Clock::now();
    m_simulation->step();
    m_seconds += m_simulation->world().options().laws.timeStep;
    m_meter.add(Clock::now() - begun, m_simulation->world(), m_isPlaying);
}

double LiveRun::wayOfStep() const
{
    return m_simulation->world().options().laws.timeStep / m_speed;
}

LiveSimulation::Frame LiveRun::frame() const
{
    LiveSimulation::Frame frame;
    frame.isStarted = m_simulation.has_value();
    frame.isPlaying = m_isPlaying;
    frame.isReplaying = m_replay.has_value();
    frame.figures = m_meter.figures();
    frame.remark = m_remark;
    if (m_simulation) {
        const World &world = m_simulation->world();
        frame.isRecorded = m_simulation->isRecorded();
        frame.stepCount = world.stepCount();
        frame.seconds = m_seconds;
        frame.due = m_due;
        frame.way = Seconds(m_isPlaying ? wayOfStep() : 0.0);
        frame.energy = m_simulation->energy();
        frame.lostSteps = world.lostSteps();
        for (std::uint32_t place = 0; place < world.placeCount(); ++place) {
            frame.places.push_back({m_simulation->places().surroundings(place), world.surface(place)});
        }
        frame.ownBalls = m_ownBalls;
        frame.balls.reserve(world.balls().size());
        for (std::size_t i = 0; i < world.balls().size(); ++i) {
            const BallState &ball = world.balls()[i];
            const unsigned contacts = world.reports()[i].contacts;
            frame.contacts += contacts;
            frame.balls.push_back({m_numbers[i], m_marks[i], m_simulation->before()[i], ball.position, ball.velocity,
                                   ball.radius, ball.restitution, contacts, ball.isAsleep, ball.place});
        }
    }
    return frame;
}

}
