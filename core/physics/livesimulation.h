// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "simulation.h"
#include "stepmeter.h"

namespace romanesco {

/// A simulation that goes on by itself, on a thread of its own, as fast as a clock says; where that cannot be kept it goes
/// slower and tells so. All that is asked for happens soon, in order, between steps. Nothing is made before it is needed: until
/// something moves or is dropped there is a scene and no more.
class LiveSimulation
{
public:
    using Clock = std::chrono::steady_clock;

    struct BallFrame {
        /// Its own as long as it lives; those of the scene are counted from 0.
        std::uint64_t number = 0;
        /// What drop() was told; 0 for the scene's own.
        unsigned mark = 0;
        /// The centre at the last step but one, and at the last.
        glm::dvec3 before{0.0};
        glm::dvec3 after{0.0};
        glm::dvec3 velocity{0.0};
        double radius = 0.0;
        double restitution = 0.0;
        unsigned contacts = 0;
        bool isAsleep = false;
        /// Of Frame::places, what all of it is counted from.
        std::uint32_t place = 0;
    };

    /// What balls are counted from: the world, or a place in it.
    struct Place {
        /// Null in the world.
        std::shared_ptr<const Surroundings> surroundings;
        /// What they fall on.
        std::shared_ptr<const Surface> surface;
    };

    /// What there is to see. Immutable.
    struct Frame {
        /// Empty unless isStarted.
        std::vector<BallFrame> balls;
        /// There are balls apart from the scene's own picture of them.
        bool isStarted = false;
        bool isPlaying = false;
        bool isReplaying = false;
        /// All that was done can be recorded.
        bool isRecorded = true;
        std::uint64_t stepCount = 0;
        /// Simulated since the start.
        double seconds = 0.0;
        /// When balls are where they are after the last step, and how long they take there from where they were before.
        Clock::time_point due;
        std::chrono::duration<double> way{0.0};
        StepMeter::Figures figures;
        /// Kinetic and of height, of all balls, in the world's units: their mass is their volume.
        double energy = 0.0;
        unsigned contacts = 0;
        /// Times that a ball was not done with a step.
        std::uint64_t lostSteps = 0;
        /// So many balls were the scene's own, numbered from 0, at the start.
        std::size_t ownBalls = 0;
        /// The first is the world; none unless isStarted.
        std::vector<Place> places;
        /// What was not possible, or what a replay came to: a sentence, or empty.
        std::string remark;
    };

    /// changed is called on the thread whenever newest() is another, some hundred times a second at most.
    explicit LiveSimulation(std::function<void()> changed);
    /// Waits for the step under way.
    ~LiveSimulation();
    LiveSimulation(const LiveSimulation &) = delete;
    LiveSimulation &operator=(const LiveSimulation &) = delete;

    [[nodiscard]] std::shared_ptr<const Frame> newest() const;

    // From any thread; none of these waits.

    /// Where something has moved, balls stay as they are and have this scene's surface from now on. Null is no scene.
    void setScene(std::shared_ptr<const Scene> scene);
    /// Balls and scene are others: all starts anew, at rest.
    void startScene(std::shared_ptr<const Scene> scene);
    void setRules(const World::Options &world);
    void setCollider(const SceneCollider::Options &collider);
    /// Simulated seconds for each that goes by; above 0.
    void setSpeed(double speed);
    void play();
    void pause();
    /// Pauses, and makes one.
    void step();
    /// To the scene's start; nothing plays.
    void reset();
    /// At a place, or in the world. mark is for whoever looks at frames, such as a colour.
    void drop(std::vector<Ball> balls, unsigned mark = 0, std::optional<ScenePlace> place = std::nullopt);
    void remove(std::uint64_t number);
    /// What was recorded so far is told on the thread; the error is a sentence.
    void record(std::function<void(std::expected<Recording, std::string>)> told);
    /// From the scene's start; the frame's remark tells whether it came to the same. Whatever else is done ends it.
    void replay(Recording recording);

private:
    class Worker;

    std::unique_ptr<Worker> m_worker;
};

}
