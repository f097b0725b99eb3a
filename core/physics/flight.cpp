// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "flight.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "landing.h"

namespace romanesco {

namespace {

/// Of the radius: on longer ways the sweep is asked first.
constexpr double shortWay = 0.25;
/// Of the radius: on longer ways it is asked again, where the one before did not last.
constexpr double longWay = 4.0;
/// What is measured lasts for so many steps.
constexpr double reachInWays = 8.0;
/// Steps that are swept at once, where the chord of so many bends by no more than this, of the radius.
constexpr double stepsAhead = 8.0;
constexpr double mostSag = 0.1;
/// Of the skin, where sweeps stop.
constexpr double standOff = 0.5;
/// A chord that ends a little beyond the plane that is fallen on.
constexpr double beyond = 1.05;
constexpr int mostShorter = 60;
/// Chords that are of no use are made so much shorter, down to such a share of a time step.
constexpr double shorter = 0.25;
constexpr double leastTime = 1e-9;

/// A part of a parabola, and the sphere that holds the ball all along it: the ball bends away from the chord, to one side.
struct Chord {
    double time = 0.0;
    glm::dvec3 way{0.0};
    double length = 0.0;
    /// How far it bends at most, and to where.
    double sag = 0.0;
    glm::dvec3 bend{0.0};
};

Chord chordOf(const glm::dvec3 &v, const glm::dvec3 &a, double time)
{
    Chord chord{.time = time};
    chord.way = time * v + (0.5 * time * time) * a;
    chord.length = glm::length(chord.way);
    if (chord.length > 0.0) {
        const glm::dvec3 along = chord.way / chord.length;
        const glm::dvec3 across = a - glm::dot(a, along) * along;
        const double strength = glm::length(across);
        chord.sag = 0.125 * time * time * strength;
        chord.bend = strength > 0.0 ? -across / strength : glm::dvec3(0.0);
    }
    return chord;
}

/// When the ball is so far along its chord.
double timeAlong(const Chord &chord, const glm::dvec3 &v, const glm::dvec3 &a, double way)
{
    const glm::dvec3 along = chord.way / chord.length;
    const double speed = glm::dot(v, along);
    const double pull = glm::dot(a, along);
    const double root = std::sqrt(std::max(0.0, speed * speed + 2.0 * pull * way));
    const double sum = speed + root;
    return sum > 0.0 ? std::clamp(2.0 * way / sum, 0.0, chord.time) : 0.0;
}

/// Until a plane in that direction, which is so far away, would be met; infinite where it is not.
double timeToFall(const glm::dvec3 &v, const glm::dvec3 &a, const glm::dvec3 &direction, double distance)
{
    const double speed = -glm::dot(v, direction);
    const double pull = -glm::dot(a, direction);
    const double square = speed * speed + 2.0 * pull * distance;
    const double sum = speed + std::sqrt(std::max(0.0, square));
    return square >= 0.0 && sum > 0.0 ? 2.0 * distance / sum : std::numeric_limits<double>::infinity();
}

class Flight
{
public:
    explicit Flight(BallStep &step)
        : m_step(step)
        , m_ball(step.ball())
        , m_gravity(step.laws().gravity)
    {
    }

    void run()
    {
        if (isFree() || isForeseen()) {
            return;
        }
        if (!goToForeseen() && pathFor(m_step.left()) <= shortWay * m_step.radius() && look()) {
            return;
        }
        while (m_step.left() > 0.0 && m_ball.supports.isEmpty() && !m_step.probe().isExhausted()) {
            if (isFree()) {
                return;
            }
            if (!sweepOn()) {
                giveUp();
                return;
            }
        }
    }

private:
    [[nodiscard]] double pathFor(double time) const { return longestWay(m_ball.velocity, m_gravity, time); }

    /// Goes to the end where nothing can be in the way.
    bool isFree()
    {
        const double path = pathFor(m_step.left());
        if (m_step.room() <= path + m_step.rounding()) {
            return false;
        }
        advance(m_step.left(), path);
        return true;
    }

    /// How long the way that was swept in a step before is free from here.
    [[nodiscard]] double foreseenTime() const
    {
        return m_ball.foresight.velocity == m_ball.velocity ? m_ball.foresight.time : 0.0;
    }

    /// Goes to the end where that is known to be free.
    bool isForeseen()
    {
        const double time = foreseenTime();
        if (time < m_step.left()) {
            return false;
        }
        goFree(time, m_step.radius(), m_ball.foresight.endsNear);
        return true;
    }

    /// Goes as far as is known to be free, to what is touched next. Whether there is such a thing.
    bool goToForeseen()
    {
        const double time = foreseenTime();
        if (time <= 0.0 || !m_ball.foresight.endsNear) {
            return false;
        }
        advance(time, pathFor(time));
        m_step.setClearance(m_step.radius());
        arrive(mostSag * m_step.radius());
        (void)landsOrStands();
        return true;
    }

    /// At what may be touched next, from within a gap.
    void arrive(double gap)
    {
        m_step.measure(gap + 2.0 * m_step.skin());
        m_isNear = m_step.hasDirection() && !m_step.isTouching();
        m_looksAhead = false;
    }

    /// To the end of the step, and on for a time that is free from here and no less.
    void goFree(double time, double radius, bool endsNear)
    {
        const double left = m_step.left();
        advance(left, pathFor(left));
        m_step.setClearance(radius);
        if (time > left && m_step.radius() == m_ball.radius) { // else it is smaller in this step alone
            m_ball.foresight = {time - left, m_ball.velocity, endsNear};
        }
    }

    void advance(double time, double path) { m_step.advance(time, m_gravity, path); }

    /// Asks what is near. Whether the ball has gone on, or has landed where it is.
    bool look()
    {
        m_step.measure(reachInWays * pathFor(m_step.left()) + 2.0 * m_step.skin());
        return isFree() || landsOrStands();
    }

    /// Where it touches: lands it, once at a place. Whether something holds it up then.
    bool landsOrStands()
    {
        if (!m_step.isTouching()) {
            return false;
        }
        m_step.pushOut();
        if (!std::exchange(m_hasLanded, true)) {
            land(m_step);
            m_looksAhead = true;
        }
        return !m_ball.supports.isEmpty();
    }

    /// The longest chord that the ball can be swept along from where it is.
    [[nodiscard]] Chord nextChord(double growth) const
    {
        // By distances that are too great what is touched at the end would be taken for free, again and again.
        const double ahead =
            m_looksAhead && m_step.probe().surface().isExact ? stepsAhead * m_step.laws().timeStep : 0.0;
        double time = timeForward(m_ball.velocity, m_gravity, std::min(std::max(m_step.left(), ahead), m_longest));
        if (m_isNear) {
            time = std::min(time, beyond * timeToFall(m_ball.velocity, m_gravity, m_step.direction(), m_step.room()));
        }
        Chord chord = chordOf(m_ball.velocity, m_gravity, time);
        while (chord.time > m_step.left() && chord.sag > mostSag * m_step.radius()) {
            time = std::max(0.7 * time, m_step.left());
            chord = chordOf(m_ball.velocity, m_gravity, time);
        }
        for (int i = 0; i < mostShorter && growthOf(chord) > growth; ++i) {
            time *= std::clamp(0.9 * std::sqrt(growth / growthOf(chord)), 1e-3, 0.7);
            chord = chordOf(m_ball.velocity, m_gravity, time);
        }
        return chord;
    }

    /// By how much the sphere round a chord comes nearer to what the ball stands on.
    [[nodiscard]] double growthOf(const Chord &chord) const
    {
        const bool knowsWhere = m_step.hasDirection() && !m_isCautious;
        const double lean = knowsWhere ? glm::dot(chord.bend, m_step.direction()) : -1.0;
        return 0.5 * chord.sag * (1.0 - std::min(lean, 1.0));
    }

    /// The next chord. Whether that was of any use.
    bool sweepOn()
    {
        const double room = m_step.room();
        const double stand = standOff * (room > 0.0 ? std::min(room, m_step.skin()) : m_step.skin());
        // how near it is to what it may touch at once is not asked before it does
        const Chord chord =
            nextChord(m_step.isMeasured() ? std::max(0.0, room - stand) : std::numeric_limits<double>::infinity());
        if (chord.length == 0.0) { // too little to be told
            const double path = pathFor(m_step.left());
            if (path > m_step.skin()) {
                return false;
            }
            advance(m_step.left(), path);
            return true;
        }
        const double radius = m_step.radius() + stand;
        const double share = m_step.probe().freeShare(m_ball.position + 0.5 * chord.sag * chord.bend, chord.way,
                                                      radius + 0.5 * chord.sag);
        const double time =
            share < 1.0 ? timeAlong(chord, m_ball.velocity, m_gravity, share * chord.length) : chord.time;
        if (time >= m_step.left()) {
            goFree(time, radius, share < 1.0);
            return true;
        }
        if (share < 1.0) {
            return goToTouch(chord, time, radius);
        }
        advance(chord.time, pathFor(chord.time));
        m_step.setClearance(radius);
        m_isNear = m_hasLanded = m_isCautious = false;
        m_longest = std::numeric_limits<double>::infinity();
        if (m_step.left() > 0.0 && pathFor(m_step.left()) <= longWay * m_step.radius()) {
            (void)look();
        }
        return true;
    }

    bool goToTouch(const Chord &chord, double time, double radius)
    {
        const bool hasMoved = time > 0.0;
        if (hasMoved) {
            advance(time, pathFor(time));
            m_step.setClearance(radius);
            m_hasLanded = m_isCautious = false;
        }
        arrive(chord.sag);
        m_longest = std::numeric_limits<double>::infinity();
        const bool hadLanded = m_hasLanded;
        if (landsOrStands() || hasMoved || m_hasLanded != hadLanded || !std::exchange(m_isCautious, true)) {
            return true;
        }
        // It goes away from what it touches and is pulled back to it on the way.
        m_longest = shorter * chord.time;
        return (m_step.isTouching() && settle(m_step)) || chord.time > leastTime * m_step.laws().timeStep;
    }

    void giveUp()
    {
        if (m_step.probe().surface().isProved) {
            m_step.lose();
        } else {
            advance(m_step.left(), pathFor(m_step.left())); // it may go through, which is what it does
        }
    }

    BallStep &m_step;
    BallState &m_ball;
    const glm::dvec3 m_gravity;
    bool m_hasLanded = false;
    bool m_isNear = false;
    bool m_isCautious = false;
    /// What is near is touched in short ways.
    bool m_looksAhead = true;
    /// What is tried next.
    double m_longest = std::numeric_limits<double>::infinity();
};

}

void fly(BallStep &step)
{
    Flight(step).run();
}

}
