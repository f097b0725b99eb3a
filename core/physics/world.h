// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ballstep.h"
#include "core/base/threadteam.h"
#include "core/scene/anchor.h"

namespace romanesco {

/// Balls on a surface and among each other. One thread at a time; a step shares its work among threads, and comes to the
/// same on any number of them: each ball is stepped by itself, or with those that it may touch (see stepIsland()), and what
/// it comes to is put where it belongs.
///
/// Balls may be counted from places beside the world, each with a unit and a surface of its own, so that what is near one
/// keeps its precision however small it is. Balls of two places pass one another.
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
    void add(const Ball &ball, std::uint32_t place = 0);

    /// Of the balls that follow, each has a number less by one.
    void remove(std::size_t ball);

    /// Another surface, or another way to search it; balls that are there stay where they are, and wake. A place is new where
    /// its number is their count; its unit is that of the world's. The world's own surface is that of place 0.
    void setSurface(Surface surface, std::uint32_t place = 0, double unit = 1.0);
    [[nodiscard]] std::size_t placeCount() const { return m_places.size(); }

    /// Counts a ball from another place, where its coordinates are what the moves make of them.
    void recount(std::size_t ball, std::uint32_t place, std::span<const Anchor::Move> moves);

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
    [[nodiscard]] const std::shared_ptr<const Surface> &surface(std::uint32_t place = 0) const
    {
        return m_places[place].surface;
    }
    /// As they are at a place.
    [[nodiscard]] const Laws &laws(std::uint32_t place) const { return m_places[place].laws; }
    /// How often a ball has lost the rest of a step.
    [[nodiscard]] std::uint64_t lostSteps() const { return m_lostSteps; }

    /// Of all that the next steps depend on.
    [[nodiscard]] std::uint64_t stateHash() const;

private:
    struct Place {
        double unit = 1.0;
        Laws laws;
        std::shared_ptr<const Surface> surface;
        /// One for each thread.
        std::vector<std::unique_ptr<Probe>> probes;
    };

    void setLaws(Place &place) const;
    static void wake(BallState &ball);
    void shrink();
    void stepAlone(std::size_t ball, unsigned thread);
    void stepTogether();

    Options m_options;
    std::vector<Place> m_places;
    std::vector<BallState> m_balls;
    std::vector<double> m_radiiAtStart;
    /// Steps made before each was added.
    std::vector<std::uint64_t> m_addedAt;
    std::vector<StepReport> m_reports;
    std::uint64_t m_stepCount = 0;
    std::uint64_t m_lostSteps = 0;
    ThreadTeam m_team;
};

}
