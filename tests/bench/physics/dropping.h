// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/collide/collider.h"
#include "falling.h"

namespace romanesco::bench {

/// How many balls fall, for how long.
struct Drop {
    Start start = Start::Drop;
    double radius = 0.02;
    std::size_t balls = 1'000;
    std::size_t steps = 480;
    Falling::Options options = {};
    /// Of a shot.
    double speed = 0.0;
};

/// What it took. Of each step the least time of all rounds, since what else the machine does only adds to it.
struct Timing {
    /// Of all threads.
    double cpuSeconds = 0.0;
    double wallSeconds = 0.0;
    /// The longest quarter of a second of the simulated time, in wall seconds.
    double slowest = 0.0;
    /// Of balls that are awake and not yet past the ground.
    std::size_t ballSteps = 0;
    /// Of these, of balls that touch something.
    std::size_t touching = 0;
    std::size_t lost = 0;
    /// After each step, of all balls; kept where they are asked for.
    std::vector<std::vector<glm::dvec3>> positions = {};
};
[[nodiscard]] Timing timed(const Engine &engine, const Ground &ground, const Drop &drop, int rounds,
                           bool keepsPositions);

/// How deep balls have sunk in, in parts of their radius, each at its deepest; and how many of them went through.
struct Sinking {
    double most = 0.0;
    double median = 0.0;
    /// Those whose centres are on the other side of a face after some step. For an engine that goes straight on in a step
    /// it is exact; else a way that bends round something may count too.
    std::size_t tunnelled = 0;
};
[[nodiscard]] Sinking sunk(const Collider &exact, const std::vector<std::vector<glm::dvec3>> &positions, double radius);

}
