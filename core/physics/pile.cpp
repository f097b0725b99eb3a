// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "pile.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "ballstepper.h"

namespace romanesco {

namespace {

constexpr int sweeps = 50;
constexpr int sweepsOfOverlap = 30;
constexpr int rounds = 6;
constexpr double lean = 1e-6;
/// Of the radius: where a ball comes to lie off a surface.
constexpr double near = 5e-5;
/// Of an overlap, what is taken out in a step.
constexpr double correction = 0.4;
/// Of the speed that falling by half a radius gives: what is slower so many steps long falls asleep.
constexpr double calmShare = 0.02;
constexpr unsigned stepsToSleep = 60;

/// Two balls that press each other, or may within the step.
struct Press {
    std::size_t one;
    std::size_t other;
    glm::dvec3 direction;
    /// What the first takes of a change of their speed.
    double shareOfOne;
    /// That they part with at least.
    double speed;
    double impulse = 0.0;
};

/// A ball and a plane that it lies against, or may come to within the step.
struct Lie {
    std::size_t ball;
    glm::dvec3 direction;
    /// That they part with at least.
    double speed;
    double impulse = 0.0;
};

/// What bounces are reckoned from.
struct Before {
    glm::dvec3 velocity;
    double restitution;
};

class Pile
{
public:
    Pile(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
         Probe &probe)
        : m_island(island)
        , m_balls(balls)
        , m_reports(reports)
        , m_laws(laws)
        , m_probe(probe)
        , m_met(island.balls.size())
    {
    }

    void run()
    {
        for (const std::size_t ball : m_island.balls) {
            lieDown(ball);
        }
        for (const BallPair &pair : m_island.pairs) {
            press(pair);
        }
        for (const std::size_t ball : m_island.balls) {
            m_before.push_back({m_balls[ball].velocity, m_balls[ball].restitution});
            m_balls[ball].velocity += m_laws.timeStep * m_laws.gravityOn(m_balls[ball]);
        }
        // balls that are pressed find surfaces that they would not have gone against
        for (int round = 0; round < rounds && (findLies() || round == 0); ++round) {
            for (int sweep = 0; sweep < sweeps; ++sweep) {
                relax(m_presses, m_lies, [this](std::size_t ball) -> glm::dvec3 & { return m_balls[ball].velocity; });
            }
        }
        for (const std::size_t ball : m_island.balls) {
            move(ball);
        }
        takeOutOverlap();
        rest();
    }

private:
    void lieDown(std::size_t ball)
    {
        BallState &state = m_balls[ball];
        m_reports[ball] = {};
        state.isAsleep = false;
        state.supports.clear();
    }

    /// Finds what surfaces balls go against by the velocities that they have now. Whether there are any that were not known.
    bool findLies()
    {
        bool hasFound = false;
        for (std::size_t i = 0; i < m_island.balls.size(); ++i) {
            const BallState &state = m_balls[m_island.balls[i]];
            // turned away from what is known, which would hide what is not
            glm::dvec3 motion = m_met[i].allowed(state.velocity);
            for (const glm::dvec3 &n : m_met[i].directions()) {
                motion += lean * glm::length(motion) * n;
            }
            if (motion == glm::dvec3(0.0)) {
                continue;
            }
            m_probe.begin(m_laws.budget);
            const double reach = state.radius * (1.0 + near) + glm::length(state.velocity) * m_laws.timeStep;
            const auto nearest = m_probe.nearest(state.position, reach, motion);
            count(m_island.balls[i]);
            if (nearest.isFound && !m_met[i].holds(nearest.direction) && m_met[i].add(nearest.direction)) {
                m_lies.push_back({m_island.balls[i], nearest.direction, partingSpeed(m_before[i], state, nearest)});
                hasFound = true;
            }
        }
        return hasFound;
    }

    /// From a surface: that of the bounce, or what brings the ball just to it.
    [[nodiscard]] double partingSpeed(const Before &before, const BallState &ball, const Probe::Nearest &nearest) const
    {
        const double timeStep = m_laws.timeStep;
        const double e = before.restitution;
        const double room = std::max(0.0, nearest.clearance - ball.radius * (1.0 + near));
        const double against = -glm::dot(before.velocity, nearest.direction);
        const bool isLeftOut = 2.0 * e * against < timeStep * glm::length(m_laws.gravityOn(ball)) * (1.0 - e);
        return against * timeStep > room && !isLeftOut ? e * against : -room / timeStep;
    }

    void count(std::size_t ball)
    {
        m_reports[ball].cost.faceTests += m_probe.cost().faceTests;
        m_reports[ball].cost.nodeVisits += m_probe.cost().nodeVisits;
        m_reports[ball].queries += m_probe.queries();
    }

    void press(const BallPair &pair)
    {
        const BallState &one = m_balls[pair.one];
        const BallState &other = m_balls[pair.other];
        const glm::dvec3 apart = one.position - other.position;
        const double distance = glm::length(apart);
        const glm::dvec3 n = distance > 0.0 ? apart / distance : glm::dvec3(0.0, 1.0, 0.0);
        const double gap = distance - one.radius - other.radius;
        const double against = -glm::dot(one.velocity - other.velocity, n);
        const double e = std::sqrt(one.restitution * other.restitution);
        const double timeStep = m_laws.timeStep;
        const bool isLeftOut = 2.0 * e * against < timeStep * glm::length(m_laws.gravityOn(one)) * (1.0 - e);
        const bool bounces = against > 0.0 && gap <= against * timeStep && !isLeftOut;
        const double ratio = one.radius / other.radius;
        m_presses.push_back({pair.one, pair.other, n, 1.0 / (1.0 + ratio * ratio * ratio),
                             bounces ? e * against : -std::max(gap, 0.0) / timeStep});
    }

    /// A sweep over the speeds, or the ways, of balls.
    template<typename SpeedOf>
    static void relax(std::span<Press> presses, std::span<Lie> lies, const SpeedOf &speedOf)
    {
        for (Press &press : presses) {
            glm::dvec3 &one = speedOf(press.one);
            glm::dvec3 &other = speedOf(press.other);
            const double wanted = press.speed - glm::dot(one - other, press.direction);
            const double impulse = std::max(0.0, press.impulse + wanted);
            const double change = impulse - press.impulse;
            press.impulse = impulse;
            one += change * press.shareOfOne * press.direction;
            other -= change * (1.0 - press.shareOfOne) * press.direction;
        }
        for (Lie &lie : lies) {
            glm::dvec3 &v = speedOf(lie.ball);
            const double impulse = std::max(0.0, lie.impulse + lie.speed - glm::dot(v, lie.direction));
            v += (impulse - lie.impulse) * lie.direction;
            lie.impulse = impulse;
        }
    }

    /// By its velocity alone, which has gravity's part already.
    void move(std::size_t ball)
    {
        BallState &state = m_balls[ball];
        Laws still = m_laws;
        still.gravity = glm::dvec3(0.0);
        const double restitution = std::exchange(state.restitution, 0.0);
        state.supports.clear();
        state.foresight = {}; // of a flight under gravity
        const StepReport moved = stepBall(state, still, m_probe, m_laws.timeStep);
        state.restitution = restitution;
        state.foresight = {};
        state.isAsleep = false;
        StepReport &report = m_reports[ball];
        count(ball);
        report.contacts += moved.contacts;
        report.isExhausted = moved.isExhausted;
    }

    [[nodiscard]] std::size_t placeOf(std::size_t ball) const
    {
        return static_cast<std::size_t>(std::ranges::lower_bound(m_island.balls, ball) - m_island.balls.begin());
    }

    /// A part of it, from all of the pile at once: what is pushed up pushes up what lies on it.
    void takeOutOverlap()
    {
        std::vector<Press> presses;
        bool isAny = false;
        for (const Press &press : m_presses) {
            const BallState &one = m_balls[press.one];
            const BallState &other = m_balls[press.other];
            const double overlap = one.radius + other.radius - glm::distance(one.position, other.position);
            isAny = isAny || overlap > 0.0;
            presses.push_back({placeOf(press.one), placeOf(press.other), press.direction, press.shareOfOne,
                               overlap > 0.0 ? correction * overlap : overlap});
        }
        if (!isAny) {
            return;
        }
        std::vector<Lie> lies;
        for (const Lie &lie : m_lies) {
            if (lie.impulse > 0.0) {
                lies.push_back({placeOf(lie.ball), lie.direction, 0.0});
            }
        }
        std::vector<glm::dvec3> ways(m_island.balls.size(), glm::dvec3(0.0));
        for (int sweep = 0; sweep < sweepsOfOverlap; ++sweep) {
            relax(presses, lies, [&](std::size_t place) -> glm::dvec3 & { return ways[place]; });
        }
        for (std::size_t i = 0; i < ways.size(); ++i) {
            if (ways[i] != glm::dvec3(0.0)) {
                shift(m_island.balls[i], ways[i]);
            }
        }
    }

    /// As far as the surface allows.
    void shift(std::size_t ball, const glm::dvec3 &way)
    {
        BallState &state = m_balls[ball];
        BallStep step(state, m_laws, m_probe, m_laws.timeStep);
        step.measure(glm::length(way));
        const double room = 0.75 * std::min(step.room(), step.skin());
        if (room > 0.0) {
            const double share = m_probe.freeShare(state.position, way, state.radius + room);
            step.moveTo(state.position + share * way, share * glm::length(way));
        }
        count(ball);
    }

    /// Counts the steps of little motion; all fall asleep together.
    void rest()
    {
        for (const std::size_t ball : m_island.balls) {
            BallState &state = m_balls[ball];
            state.isPiled = false;
            const double calm = calmShare * calmShare * glm::length(m_laws.gravityOn(state)) * state.radius;
            state.calmSteps = glm::dot(state.velocity, state.velocity) <= calm ? state.calmSteps + 1 : 0;
        }
        for (const Press &press : m_presses) {
            if (press.impulse > 0.0) {
                for (const std::size_t ball : {press.one, press.other}) {
                    m_balls[ball].isPiled = true;
                    ++m_reports[ball].contacts;
                }
            }
        }
        const bool isCalm = std::ranges::all_of(
            m_island.balls, [&](std::size_t ball) { return m_balls[ball].calmSteps >= stepsToSleep; });
        for (const std::size_t ball : m_island.balls) {
            if (isCalm) {
                m_balls[ball].velocity = glm::dvec3(0.0);
                m_balls[ball].isAsleep = true;
            }
        }
    }

    const BallIsland &m_island;
    std::span<BallState> m_balls;
    std::span<StepReport> m_reports;
    const Laws &m_laws;
    Probe &m_probe;
    std::vector<Press> m_presses;
    std::vector<Lie> m_lies;
    /// Beside the island's balls.
    std::vector<Before> m_before;
    std::vector<Supports> m_met;
};

}

void stepPile(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
              Probe &probe)
{
    Pile(island, balls, reports, laws, probe).run();
}

}
