// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "islandstep.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "ballstepper.h"
#include "meeting.h"
#include "pile.h"

namespace romanesco {

namespace {

/// An island with more of them lies still, or soon will.
constexpr int mostCollisions = 8;

/// Of balls that meet in the air.
class Collisions
{
public:
    Collisions(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
               Probe &probe)
        : m_island(island)
        , m_balls(balls)
        , m_reports(reports)
        , m_laws(laws)
        , m_probe(probe)
        , m_paths(island.balls.size())
    {
    }

    /// False where there are too many of them.
    bool run()
    {
        for (const std::size_t ball : m_island.balls) {
            m_reports[ball] = {};
            go(ball, 0.0);
        }
        m_meetings.resize(m_island.pairs.size());
        for (std::size_t i = 0; i < m_meetings.size(); ++i) {
            find(i, 0.0);
        }
        for (int collisions = 0;; ++collisions) {
            const auto first = std::ranges::min_element(m_meetings, {}, &Meeting::time);
            if (first == m_meetings.end() || first->time > m_laws.timeStep) {
                return true;
            }
            if (collisions == mostCollisions) {
                return false;
            }
            meet(m_island.pairs[static_cast<std::size_t>(first - m_meetings.begin())], first->time);
        }
    }

private:
    struct Meeting {
        double time = std::numeric_limits<double>::infinity();
    };

    std::vector<BallPath> &pathsOf(std::size_t ball)
    {
        const auto at = std::ranges::lower_bound(m_island.balls, ball);
        return m_paths[static_cast<std::size_t>(at - m_island.balls.begin())];
    }

    /// From where it is, at a time, to the end of the step.
    void go(std::size_t ball, double from)
    {
        BallState &state = m_balls[ball];
        std::vector<BallPath> &paths = pathsOf(ball);
        const std::size_t first = paths.size();
        const BallState before = state;
        StepReport report = stepBall(state, m_laws.of(state), m_probe, m_laws.timeStep - from, &paths);
        for (std::size_t i = first; i < paths.size(); ++i) {
            paths[i].start += from;
        }
        const double gone = paths.size() > first ? paths.back().end() : from;
        if (gone < m_laws.timeStep) {
            // it rests, or has lost the rest
            paths.push_back({gone, m_laws.timeStep - gone, glm::dvec3(0.0), paths.size() > first ? state : before});
            paths.back().from.velocity = glm::dvec3(0.0);
        }
        StepReport &all = m_reports[ball];
        report.cost.faceTests += all.cost.faceTests;
        report.cost.nodeVisits += all.cost.nodeVisits;
        report.queries += all.queries;
        report.contacts += all.contacts;
        report.isExhausted = report.isExhausted || all.isExhausted;
        all = report;
    }

    void find(std::size_t pair, double from)
    {
        const auto &[one, other] = m_island.pairs[pair];
        m_meetings[pair].time =
            meetingOf(pathsOf(one), pathsOf(other), from).value_or(std::numeric_limits<double>::infinity());
    }

    /// Takes a ball back to where it was at a time; its acceleration there.
    glm::dvec3 rewind(std::size_t ball, double time)
    {
        std::vector<BallPath> &paths = pathsOf(ball);
        while (paths.size() > 1 && paths.back().start > time) {
            paths.pop_back();
        }
        BallPath &last = paths.back();
        BallState &state = m_balls[ball];
        state = last.from;
        state.position = last.positionAt(time);
        state.velocity = last.velocityAt(time);
        state.clearance = std::max(0.0, last.from.clearance - glm::distance(last.from.position, state.position));
        state.foresight = {};
        last.time = time - last.start;
        return last.acceleration;
    }

    void meet(const BallPair &pair, double time)
    {
        BallState &one = m_balls[pair.one];
        BallState &other = m_balls[pair.other];
        const glm::dvec3 pull = rewind(pair.one, time) - rewind(pair.other, time);
        const glm::dvec3 apart = glm::normalize(one.position - other.position);
        collide(one, other, -glm::dot(pull, apart), m_laws.timeStep);
        for (const std::size_t ball : {pair.one, pair.other}) {
            m_balls[ball].isAsleep = false;
            m_balls[ball].supports.clear();
            ++m_reports[ball].contacts;
            go(ball, time);
        }
        for (std::size_t i = 0; i < m_meetings.size(); ++i) {
            const BallPair &changed = m_island.pairs[i];
            if (changed.one == pair.one || changed.one == pair.other || changed.other == pair.one
                || changed.other == pair.other) {
                find(i, time);
            }
        }
    }

    const BallIsland &m_island;
    std::span<BallState> m_balls;
    std::span<StepReport> m_reports;
    const Laws &m_laws;
    Probe &m_probe;
    /// Beside the island's balls.
    std::vector<std::vector<BallPath>> m_paths;
    /// Beside its pairs.
    std::vector<Meeting> m_meetings;
};

}

void stepIsland(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
                const Crew &crew)
{
    const bool isPile = std::ranges::any_of(island.balls, [&](std::size_t ball) { return balls[ball].isPiled; });
    if (!isPile) {
        std::vector<BallState> before;
        before.reserve(island.balls.size());
        for (const std::size_t ball : island.balls) {
            before.push_back(balls[ball]);
        }
        if (Collisions(island, balls, reports, laws, crew.own()).run()) {
            return;
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            balls[island.balls[i]] = before[i];
        }
    }
    stepPile(island, balls, reports, laws, crew);
}

}
