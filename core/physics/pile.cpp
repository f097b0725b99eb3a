// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "pile.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "ballstepper.h"

namespace romanesco {

namespace {

constexpr int sweeps = 50;
constexpr int sweepsOfOverlap = 60;
constexpr int rounds = 6;
constexpr double lean = 1e-6;
/// Of the radius: where a ball comes to lie off a surface.
constexpr double near = 5e-5;
/// Of an overlap, what is taken out in a step.
constexpr double correction = 0.4;
/// Of the speed that falling by half a radius gives: what is slower so many steps long falls asleep.
constexpr double calmShare = 0.02;
constexpr unsigned stepsToSleep = 60;

/// Two balls that press each other, or may within the step. Balls are numbered as in the island.
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
         const Crew &crew)
        : m_island(island)
        , m_balls(balls)
        , m_reports(reports)
        , m_laws(laws)
        , m_crew(crew)
        , m_met(island.balls.size())
        , m_found(island.balls.size())
    {
    }

    void run()
    {
        for (std::size_t i = 0; i < count(); ++i) {
            lieDown(i);
        }
        for (const BallPair &pair : m_island.pairs) {
            press(pair);
        }
        for (std::size_t i = 0; i < count(); ++i) {
            m_before.push_back({ball(i).velocity, ball(i).restitution});
            m_velocities.push_back(ball(i).velocity + m_laws.timeStep * m_laws.gravityOn(ball(i)));
        }
        // balls that are pressed find surfaces that they would not have gone against
        for (int round = 0; round < rounds && (findLies() || round == 0); ++round) {
            for (int sweep = 0; sweep < sweeps; ++sweep) {
                relax(m_presses, m_lies, m_velocities);
            }
        }
        m_crew.forEach(count(), [this](std::size_t i, Probe &probe) { move(i, probe); });
        takeOutOverlap();
        rest();
    }

private:
    [[nodiscard]] std::size_t count() const { return m_island.balls.size(); }
    [[nodiscard]] BallState &ball(std::size_t i) const { return m_balls[m_island.balls[i]]; }
    [[nodiscard]] StepReport &report(std::size_t i) const { return m_reports[m_island.balls[i]]; }

    void lieDown(std::size_t i)
    {
        report(i) = {};
        ball(i).isAsleep = false;
        ball(i).supports.clear();
    }

    /// Finds what surfaces balls go against by the velocities that they have now. Whether there are any that were not known.
    bool findLies()
    {
        m_crew.forEach(count(), [this](std::size_t i, Probe &probe) { m_found[i] = findLie(i, probe); });
        const std::size_t before = m_lies.size();
        for (const std::optional<Lie> &lie : m_found) {
            if (lie) {
                m_lies.push_back(*lie);
            }
        }
        return m_lies.size() > before;
    }

    std::optional<Lie> findLie(std::size_t i, Probe &probe)
    {
        const BallState &state = ball(i);
        const glm::dvec3 &velocity = m_velocities[i];
        // turned away from what is known, which would hide what is not
        glm::dvec3 motion = m_met[i].allowed(velocity);
        for (const glm::dvec3 &n : m_met[i].directions()) {
            motion += lean * glm::length(motion) * n;
        }
        if (motion == glm::dvec3(0.0)) {
            return std::nullopt;
        }
        probe.begin(m_laws.budget);
        const double reach = state.radius * (1.0 + near) + glm::length(velocity) * m_laws.timeStep;
        const auto nearest = probe.nearest(state.position, reach, motion);
        addCost(i, probe);
        if (!nearest.isFound || m_met[i].holds(nearest.direction) || !m_met[i].add(nearest.direction)) {
            return std::nullopt;
        }
        return Lie{i, nearest.direction, partingSpeed(m_before[i], state, nearest)};
    }

    /// From a surface: that of the bounce, or what brings the ball just to it.
    [[nodiscard]] double partingSpeed(const Before &before, const BallState &state, const Probe::Nearest &nearest) const
    {
        const double timeStep = m_laws.timeStep;
        const double e = before.restitution;
        const double room = std::max(0.0, nearest.clearance - state.radius * (1.0 + near));
        const double against = -glm::dot(before.velocity, nearest.direction);
        const bool isLeftOut = 2.0 * e * against < timeStep * glm::length(m_laws.gravityOn(state)) * (1.0 - e);
        return against * timeStep > room && !isLeftOut ? e * against : -room / timeStep;
    }

    void addCost(std::size_t i, const Probe &probe)
    {
        report(i).cost.faceTests += probe.cost().faceTests;
        report(i).cost.nodeVisits += probe.cost().nodeVisits;
        report(i).queries += probe.queries();
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
        m_presses.push_back({placeOf(pair.one), placeOf(pair.other), n, 1.0 / (1.0 + ratio * ratio * ratio),
                             bounces ? e * against : -std::max(gap, 0.0) / timeStep});
    }

    /// A sweep over the speeds, or the ways, of balls.
    static void relax(std::span<Press> presses, std::span<Lie> lies, std::span<glm::dvec3> speeds)
    {
        for (Press &press : presses) {
            glm::dvec3 &one = speeds[press.one];
            glm::dvec3 &other = speeds[press.other];
            const double wanted = press.speed - glm::dot(one - other, press.direction);
            const double impulse = std::max(0.0, press.impulse + wanted);
            const double change = impulse - press.impulse;
            press.impulse = impulse;
            one += change * press.shareOfOne * press.direction;
            other -= change * (1.0 - press.shareOfOne) * press.direction;
        }
        for (Lie &lie : lies) {
            glm::dvec3 &v = speeds[lie.ball];
            const double impulse = std::max(0.0, lie.impulse + lie.speed - glm::dot(v, lie.direction));
            v += (impulse - lie.impulse) * lie.direction;
            lie.impulse = impulse;
        }
    }

    /// By its velocity alone, which has gravity's part already.
    void move(std::size_t i, Probe &probe)
    {
        BallState &state = ball(i);
        state.velocity = m_velocities[i];
        Laws still = m_laws;
        still.gravity = glm::dvec3(0.0);
        const double restitution = std::exchange(state.restitution, 0.0);
        state.supports.clear();
        state.foresight = {}; // of a flight under gravity
        const StepReport moved = stepBall(state, still, probe, m_laws.timeStep);
        state.restitution = restitution;
        state.foresight = {};
        state.isAsleep = false;
        addCost(i, probe);
        report(i).contacts += moved.contacts;
        report(i).isExhausted = moved.isExhausted;
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
            const BallState &one = ball(press.one);
            const BallState &other = ball(press.other);
            const double overlap = one.radius + other.radius - glm::distance(one.position, other.position);
            isAny = isAny || overlap > 0.0;
            presses.push_back({press.one, press.other, press.direction, press.shareOfOne,
                               overlap > 0.0 ? correction * overlap : overlap});
        }
        if (!isAny) {
            return;
        }
        std::vector<Lie> lies;
        for (const Lie &lie : m_lies) {
            if (lie.impulse > 0.0) {
                lies.push_back({lie.ball, lie.direction, 0.0});
            }
        }
        std::vector<glm::dvec3> ways(count(), glm::dvec3(0.0));
        for (int sweep = 0; sweep < sweepsOfOverlap; ++sweep) {
            relax(presses, lies, ways);
        }
        m_crew.forEach(count(), [&](std::size_t i, Probe &probe) {
            if (ways[i] != glm::dvec3(0.0)) {
                shift(i, ways[i], probe);
            }
        });
    }

    /// As far as the surface allows.
    void shift(std::size_t i, const glm::dvec3 &way, Probe &probe)
    {
        BallState &state = ball(i);
        BallStep step(state, m_laws, probe, m_laws.timeStep);
        step.measure(glm::length(way));
        const double room = 0.75 * std::min(step.room(), step.skin());
        if (room > 0.0) {
            const double share = probe.freeShare(state.position, way, state.radius + room);
            step.moveTo(state.position + share * way, share * glm::length(way));
        }
        addCost(i, probe);
    }

    /// Counts the steps of little motion; all fall asleep together.
    void rest()
    {
        for (std::size_t i = 0; i < count(); ++i) {
            BallState &state = ball(i);
            state.isPiled = false;
            const double calm = calmShare * calmShare * glm::length(m_laws.gravityOn(state)) * state.radius;
            state.calmSteps = glm::dot(state.velocity, state.velocity) <= calm ? state.calmSteps + 1 : 0;
        }
        for (const Press &press : m_presses) {
            if (press.impulse > 0.0) {
                for (const std::size_t i : {press.one, press.other}) {
                    ball(i).isPiled = true;
                    ++report(i).contacts;
                }
            }
        }
        const bool isCalm = std::ranges::all_of(
            m_island.balls, [&](std::size_t number) { return m_balls[number].calmSteps >= stepsToSleep; });
        for (std::size_t i = 0; i < count(); ++i) {
            if (isCalm) {
                ball(i).velocity = glm::dvec3(0.0);
                ball(i).isAsleep = true;
            }
        }
    }

    const BallIsland &m_island;
    std::span<BallState> m_balls;
    std::span<StepReport> m_reports;
    const Laws &m_laws;
    const Crew &m_crew;
    std::vector<Press> m_presses;
    std::vector<Lie> m_lies;
    /// Beside the island's balls.
    std::vector<Before> m_before;
    std::vector<glm::dvec3> m_velocities;
    std::vector<Supports> m_met;
    std::vector<std::optional<Lie>> m_found;
};

}

void stepPile(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
              const Crew &crew)
{
    Pile(island, balls, reports, laws, crew).run();
}

}
