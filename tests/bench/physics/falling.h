// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "grounds.h"

namespace romanesco::bench {

/// Balls that fall on a ground, by one engine or another.
class Falling
{
public:
    struct Options {
        double timeStep = 1.0 / 240.0;
        /// Whether balls collide with each other.
        bool areSolid = false;
        unsigned threads = 1;
    };

    virtual ~Falling() = default;

    virtual void step() = 0;

    struct State {
        glm::dvec3 position{0.0};
        bool isAwake = true;
        /// Where the engine tells.
        bool isTouching = false;
    };
    /// One for each ball.
    virtual void look(std::vector<State> &states) const = 0;

    /// How often a ball has lost the rest of a step to a cap.
    [[nodiscard]] virtual std::size_t lostSteps() const { return 0; }
};

/// What an engine makes of a ground once, for any number of balls.
class Engine
{
public:
    virtual ~Engine() = default;

    [[nodiscard]] virtual std::unique_ptr<Falling> fall(const std::vector<Ball> &balls,
                                                        const Falling::Options &options) const = 0;
    /// What it took to make, of the file that was read; and bytes that are held.
    [[nodiscard]] virtual double seconds() const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

/// Ours, on the graph. The ground must outlive it.
[[nodiscard]] std::unique_ptr<Engine> worldEngine(const Ground &ground);

/// Bullet 3.24 in single precision, as it is packaged, on the written-out mesh: btBvhTriangleMeshShape, spheres with
/// continuous collision detection, a solver that goes through everything in order.
[[nodiscard]] std::unique_ptr<Engine> bulletEngine(const Ground &ground);

}
