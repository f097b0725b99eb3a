// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "world.h"

#include <algorithm>
#include <cassert>

#include "ballstepper.h"
#include "dissertationstep.h"
#include "exponential.h"
#include "islandstep.h"
#include "statehash.h"

namespace romanesco {

namespace {

/// Balls that a thread takes at once: some microseconds of work.
constexpr std::size_t ballsAtATime = 16;
/// Of the radius at the start.
constexpr double leastShare = 1e-9;

}

World::World(Surface surface, const Options &options)
    : m_options(options)
    , m_team(options.threads)
{
    assert(options.laws.timeStep > 0.0 && options.shrinkRate >= 0.0);
    setSurface(std::move(surface));
}

void World::add(const Ball &ball)
{
    assert(ball.radius > 0.0 && ball.restitution >= 0.0 && ball.restitution <= 1.0);
    m_balls.push_back({ball});
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
    wake();
}

void World::setSurface(Surface surface)
{
    m_surface = std::make_shared<const Surface>(std::move(surface));
    m_probes.clear();
    for (unsigned i = 0; i < m_team.size(); ++i) {
        m_probes.push_back(std::make_unique<Probe>(*m_surface));
    }
    wake();
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
    }
    wake();
}

void World::wake()
{
    for (BallState &ball : m_balls) {
        ball.clearance = 0.0;
        ball.foresight = {};
        ball.supports.clear();
        ball.isAsleep = false;
        ball.calmSteps = 0;
    }
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
                stepAlone(i, *m_probes[thread]);
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

void World::stepAlone(std::size_t ball, Probe &probe)
{
    const Laws &laws = m_options.laws;
    m_reports[ball] = m_options.isAsInDissertation ? stepAsInDissertation(m_balls[ball], laws, probe, laws.timeStep)
                                                   : stepBall(m_balls[ball], laws, probe, laws.timeStep);
}

void World::stepTogether()
{
    const Laws &laws = m_options.laws;
    const std::vector<BallIsland> islands = islandsOf(m_balls, nearPairs(m_balls, laws, laws.timeStep));
    std::vector<bool> isAlone(m_balls.size(), true);
    for (const BallIsland &island : islands) {
        for (const std::size_t ball : island.balls) {
            isAlone[ball] = false;
        }
    }
    m_team.run(islands.size(), 1, [&](std::size_t first, std::size_t last, unsigned thread) {
        for (std::size_t i = first; i < last; ++i) {
            stepIsland(islands[i], m_balls, m_reports, laws, *m_probes[thread]);
        }
    });
    m_team.run(m_balls.size(), ballsAtATime, [&](std::size_t first, std::size_t last, unsigned thread) {
        for (std::size_t i = first; i < last; ++i) {
            if (isAlone[i]) {
                stepAlone(i, *m_probes[thread]);
            }
        }
    });
}

std::uint64_t World::stateHash() const
{
    StateHash hash;
    hash.add(m_stepCount);
    for (const BallState &ball : m_balls) {
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
