// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "world.h"

#include <algorithm>
#include <cassert>

#include <glm/common.hpp>

#include "ballstepper.h"
#include "dissertationstep.h"
#include "exponential.h"
#include "islandstep.h"
#include "statehash.h"

namespace romanesco {

namespace {

/// Balls that a thread takes at once: some microseconds of work.
constexpr std::size_t ballsAtATime = 16;
/// Islands of so many are worth more threads than one.
constexpr std::size_t ballsToShare = 64;
/// Of the radius at the start.
constexpr double leastShare = 1e-9;
/// Of a place's units: what falls faster is gone in any case, and squares are numbers.
constexpr double mostGravity = 1e100;

}

World::World(Surface surface, const Options &options)
    : m_options(options)
    , m_team(options.threads)
{
    assert(options.laws.timeStep > 0.0 && options.shrinkRate >= 0.0);
    setSurface(std::move(surface));
}

void World::add(const Ball &ball, std::uint32_t place)
{
    assert(ball.radius > 0.0 && ball.restitution >= 0.0 && ball.restitution <= 1.0 && place < m_places.size());
    m_balls.push_back({ball, place});
    m_radiiAtStart.push_back(ball.radius);
    m_addedAt.push_back(m_stepCount);
    m_reports.emplace_back();
}

void World::remove(std::size_t ball)
{
    const auto at = static_cast<std::ptrdiff_t>(ball);
    m_balls.erase(m_balls.begin() + at);
    m_radiiAtStart.erase(m_radiiAtStart.begin() + at);
    m_addedAt.erase(m_addedAt.begin() + at);
    m_reports.erase(m_reports.begin() + at);
    std::ranges::for_each(m_balls, wake);
}

void World::setSurface(Surface surface, std::uint32_t number, double unit)
{
    assert(number <= m_places.size() && unit > 0.0);
    m_places.resize(std::max<std::size_t>(m_places.size(), number + 1));
    Place &place = m_places[number];
    place.probes.clear();
    place.surface = std::make_shared<const Surface>(std::move(surface));
    place.unit = unit;
    setLaws(place);
    for (unsigned i = 0; i < m_team.size(); ++i) {
        place.probes.push_back(std::make_unique<Probe>(*place.surface));
    }
    for (BallState &ball : m_balls) {
        if (ball.place == number) {
            wake(ball);
        }
    }
}

void World::setLaws(Place &place) const
{
    place.laws = m_options.laws;
    if (!place.laws.isGravityInRadii) {
        place.laws.gravity = glm::clamp(place.laws.gravity / place.unit, -mostGravity, mostGravity);
    }
}

void World::recount(std::size_t number, std::uint32_t place, std::span<const Anchor::Move> moves)
{
    BallState &ball = m_balls[number];
    double scale = 1.0;
    for (const Anchor::Move &move : moves) {
        ball.position = move(ball.position);
        scale *= move.scale;
    }
    ball.velocity /= scale;
    ball.radius /= scale;
    m_radiiAtStart[number] /= scale;
    ball.place = place;
    ball.clearance = 0.0;
    ball.foresight = {};
}

void World::setRules(const Options &options)
{
    assert(options.laws.timeStep > 0.0 && options.shrinkRate >= 0.0);
    m_options.laws = options.laws;
    m_options.shrinkRate = options.shrinkRate;
    m_options.isAsInDissertation = options.isAsInDissertation;
    for (std::size_t i = 0; i < m_balls.size(); ++i) {
        m_radiiAtStart[i] = m_balls[i].radius;
        m_addedAt[i] = m_stepCount;
        wake(m_balls[i]);
    }
    std::ranges::for_each(m_places, [this](Place &place) { setLaws(place); });
}

void World::wake(BallState &ball)
{
    ball.clearance = 0.0;
    ball.foresight = {};
    ball.supports.clear();
    ball.isAsleep = false;
    ball.calmSteps = 0;
}

void World::step()
{
    if (m_options.shrinkRate > 0.0) {
        shrink();
    }
    if (m_options.areSolid && !m_options.isAsInDissertation) {
        stepTogether();
    } else {
        m_team.run(m_balls.size(), ballsAtATime, [this](std::size_t first, std::size_t last, unsigned thread) {
            for (std::size_t i = first; i < last; ++i) {
                stepAlone(i, thread);
            }
        });
    }
    ++m_stepCount;
    m_lostSteps += static_cast<std::uint64_t>(std::ranges::count_if(m_reports, &StepReport::isExhausted));
}

void World::shrink()
{
    for (std::size_t i = 0; i < m_balls.size(); ++i) {
        const double time = static_cast<double>(m_stepCount + 1 - m_addedAt[i]) * m_options.laws.timeStep;
        const double share = std::max(leastShare, exponential(-m_options.shrinkRate * time));
        m_balls[i].radius = share * m_radiiAtStart[i];
        m_balls[i].isAsleep = false;
    }
}

void World::stepAlone(std::size_t number, unsigned thread)
{
    BallState &ball = m_balls[number];
    const Place &place = m_places[ball.place];
    const Laws laws = place.laws.of(ball);
    Probe &probe = *place.probes[thread];
    m_reports[number] = m_options.isAsInDissertation ? stepAsInDissertation(ball, laws, probe, laws.timeStep)
                                                     : stepBall(ball, laws, probe, laws.timeStep);
}

void World::stepTogether()
{
    std::vector<double> reaches;
    reaches.reserve(m_balls.size());
    for (const BallState &ball : m_balls) {
        reaches.push_back(reachOf(ball, m_places[ball.place].laws, m_options.laws.timeStep));
    }
    const std::vector<BallIsland> islands = islandsOf(m_balls, nearPairs(m_balls, reaches));
    std::vector<bool> isAlone(m_balls.size(), true);
    for (const BallIsland &island : islands) {
        for (const std::size_t ball : island.balls) {
            isAlone[ball] = false;
        }
    }
    const auto placeOf = [this](const BallIsland &island) -> const Place & {
        return m_places[m_balls[island.balls.front()].place];
    };
    // the threads share the large ones, and take the others one by one
    for (const BallIsland &island : islands) {
        if (island.balls.size() >= ballsToShare) {
            const Place &place = placeOf(island);
            stepIsland(island, m_balls, m_reports, place.laws, Crew(m_team, place.probes));
        }
    }
    m_team.run(islands.size(), 1, [&](std::size_t first, std::size_t last, unsigned thread) {
        for (std::size_t i = first; i < last; ++i) {
            if (islands[i].balls.size() < ballsToShare) {
                const Place &place = placeOf(islands[i]);
                stepIsland(islands[i], m_balls, m_reports, place.laws, Crew(*place.probes[thread]));
            }
        }
    });
    m_team.run(m_balls.size(), ballsAtATime, [&](std::size_t first, std::size_t last, unsigned thread) {
        for (std::size_t i = first; i < last; ++i) {
            if (isAlone[i]) {
                stepAlone(i, thread);
            }
        }
    });
}

std::uint64_t World::stateHash() const
{
    StateHash hash;
    hash.add(m_stepCount);
    for (const BallState &ball : m_balls) {
        if (ball.place > 0) {
            hash.add(m_places[ball.place].unit);
        }
        hash.add(ball.position);
        hash.add(ball.velocity);
        hash.add(ball.radius);
        hash.add(ball.restitution);
        hash.add(ball.clearance);
        hash.add(ball.foresight.time);
        hash.add(ball.foresight.velocity);
        hash.add(std::uint64_t{ball.foresight.endsNear});
        for (const glm::dvec3 &n : ball.supports.directions()) {
            hash.add(n);
        }
        hash.add(std::uint64_t{ball.isAsleep} + 2 * std::uint64_t{ball.isPiled});
        hash.add(std::uint64_t{ball.calmSteps});
    }
    return hash.value();
}

}
