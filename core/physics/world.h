// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ballstep.h"
#include "core/base/threadteam.h"

namespace romanesco {

/// Balls on a surface and among each other. One thread at a time; a step shares its work among threads, and comes to the same on any number of
/// them: each ball is stepped by itself, or with those that it may
/// touch (see stepIsland()), and what it comes to is put where it belongs.
class World
{
public:
    struct Options {
        Laws laws = {};
        /// Radii shrink by so much a second, as the power of e: to a billionth at most. Not negative.
        double shrinkRate = 0.0;
        /// Steps as the dissertation's, which tunnel, and where balls pass one another.
        bool isAsInDissertation = false;
        /// Whether balls collide with each other.
        bool areSolid = true;
        /// As many as the machine runs at once where it is 0.
        unsigned threads = 0;
    };

    World(Surface surface, const Options &options);

    /// From the next step on. Its radius is above 0, its restitution from 0 to 1.
    void add(const Ball &ball);

    /// Of the balls that follow, each has a number less by one.
    void remove(std::size_t ball);

    /// Another surface, or another way to search it; balls stay where they are, and wake.
    void setSurface(Surface surface);

    /// Other laws, another rate of shrinking or manner from the next step on; the rest stays. Balls wake. They shrink from what
    /// they are now, to a billionth of that at most.
    void setRules(const Options &options);

    void step();

    /// In the order in which they were added.
    [[nodiscard]] std::span<const BallState> balls() const { return m_balls; }
    /// Of the last step, beside the balls.
    [[nodiscard]] std::span<const StepReport> reports() const { return m_reports; }
    [[nodiscard]] std::uint64_t stepCount() const { return m_stepCount; }
    [[nodiscard]] const Options &options() const { return m_options; }
    [[nodiscard]] const std::shared_ptr<const Surface> &surface() const { return m_surface; }
    /// How often a ball has lost the rest of a step.
    [[nodiscard]] std::uint64_t lostSteps() const { return m_lostSteps; }

    /// Of all that the next steps depend on.
    [[nodiscard]] std::uint64_t stateHash() const;

private:
    void wake();
    void shrink();
    void stepAlone(std::size_t ball, Probe &probe);
    void stepTogether();

    Options m_options;
    std::shared_ptr<const Surface> m_surface;
    std::vector<BallState> m_balls;
    std::vector<double> m_radiiAtStart;
    /// Steps made before each was added.
    std::vector<std::uint64_t> m_addedAt;
    std::vector<StepReport> m_reports;
    std::uint64_t m_stepCount = 0;
    std::uint64_t m_lostSteps = 0;
    ThreadTeam m_team;
    /// One for each thread.
    std::vector<std::unique_ptr<Probe>> m_probes;
};

}
