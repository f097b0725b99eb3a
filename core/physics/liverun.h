// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "livesimulation.h"
#include "simulation.h"
#include "stepmeter.h"

namespace romanesco {

/// What a LiveSimulation does on its thread: a scene, its balls with their numbers, the rules, and when the next step is
/// due. One thread uses it. What is asked for is as LiveSimulation has it.
class LiveRun
{
public:
    using Clock = LiveSimulation::Clock;

    /// Making colliders ready ends early where that is asked for.
    explicit LiveRun(std::stop_token stop)
        : m_stop(std::move(stop))
    {
    }

    void setScene(const std::shared_ptr<const Scene> &scene, const std::stop_token &stop);
    void startScene(std::shared_ptr<const Scene> scene);
    void setRules(const World::Options &world);
    void setCollider(const SceneCollider::Options &collider);
    void setSpeed(double speed);
    void play();
    void pause();
    void step();
    void reset();
    void drop(const std::vector<Ball> &balls, unsigned mark, const std::optional<ScenePlace> &place);
    void remove(std::uint64_t number);
    void record(const std::function<void(std::expected<Recording, std::string>)> &told);
    void replay(Recording recording);

    [[nodiscard]] bool isPlaying() const { return m_isPlaying; }
    /// When the next step is to be made, while it plays.
    [[nodiscard]] Clock::time_point due() const { return m_due; }
    /// Makes one step that is due; a replay may end before.
    void advance();

    [[nodiscard]] LiveSimulation::Frame frame() const;

private:
    struct Replay {
        Recording recording;
        std::size_t next = 0;
    };

    void followReplay();
    void applyReplayed(const Recording::Input &input);
    void add(unsigned mark);
    void forget(std::ptrdiff_t at);
    bool start();
    template<typename What>
    bool apply(const What &what);
    void stepOnce();
    void say(std::string words) { m_remark = std::move(words); }
    [[nodiscard]] double wayOfStep() const;

    std::stop_token m_stop;
    std::shared_ptr<const Scene> m_scene;
    World::Options m_world;
    SceneCollider::Options m_collider;
    double m_speed = 1.0;
    bool m_isPlaying = false;
    std::optional<Simulation> m_simulation;
    /// Of it.
    double m_seconds = 0.0;
    std::optional<Replay> m_replay;
    std::string m_remark;
    /// Beside the balls.
    std::vector<std::uint64_t> m_numbers;
    std::vector<unsigned> m_marks;
    std::uint64_t m_nextNumber = 0;
    std::size_t m_ownBalls = 0;
    Clock::time_point m_due;
    StepMeter m_meter;
};

}
