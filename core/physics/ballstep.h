// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "ball.h"
#include "probe.h"

namespace romanesco {

/// The longest way that anything can go within a time.
[[nodiscard]] inline double longestWay(const glm::dvec3 &velocity, const glm::dvec3 &gravity, double time)
{
    return glm::length(velocity) * time + 0.5 * glm::length(gravity) * time * time;
}

/// What all balls of a world obey.
struct Laws {
    /// A second squared.
    glm::dvec3 gravity{0.0, -9.8, 0.0};
    /// Each ball falls by so many of its own radii, whatever its size.
    bool isGravityInRadii = false;
    /// Seconds; above 0.
    double timeStep = 1.0 / 240.0;
    /// Of one ball in one step.
    ProbeBudget budget;

    [[nodiscard]] glm::dvec3 gravityOn(const Ball &ball) const
    {
        return isGravityInRadii ? ball.radius * gravity : gravity;
    }
    /// As one ball has them: its gravity is an acceleration.
    [[nodiscard]] Laws of(const Ball &ball) const
    {
        Laws own = *this;
        own.gravity = gravityOn(ball);
        own.isGravityInRadii = false;
        return own;
    }
};

/// What a step of a ball took.
struct StepReport {
    SearchCost cost;
    unsigned queries = 0;
    /// Directions in which it touched; of a ball that rests, what it rests on.
    unsigned contacts = 0;
    /// The budget did not last: the ball has lost the rest of the step, and kept its velocity.
    bool isExhausted = false;
};

/// A part of a step: from a state on, under one acceleration.
struct BallPath {
    double start = 0.0;
    double time = 0.0;
    glm::dvec3 acceleration{0.0};
    BallState from;

    [[nodiscard]] double end() const { return start + time; }
    /// At a time of the step.
    [[nodiscard]] glm::dvec3 positionAt(double when) const
    {
        const double t = when - start;
        return from.position + t * from.velocity + (0.5 * t * t) * acceleration;
    }
    [[nodiscard]] glm::dvec3 velocityAt(double when) const { return from.velocity + (when - start) * acceleration; }
};

/// A step of a ball that is under way: what flying, landing and sliding share.
///
/// Lengths. A ball touches what is within its radius and the skin, which is 1e-4 of the radius or a multiple of the rounding
/// where that is more. Sweeps stop in the middle of it, so that a ball never starts with an overlap.
class BallStep
{
public:
    /// Where paths are wanted they are put there, one after another, counted from the step's start.
    BallStep(BallState &ball, const Laws &laws, Probe &probe, double time, std::vector<BallPath> *paths = nullptr);

    BallState &ball() { return m_ball; }
    [[nodiscard]] const BallState &ball() const { return m_ball; }
    [[nodiscard]] const Laws &laws() const { return m_laws; }
    Probe &probe() { return m_probe; }
    StepReport &report() { return m_report; }

    /// What is left of the step's time.
    [[nodiscard]] double left() const { return m_left; }
    void spend(double time) { m_left = time < m_left ? m_left - time : 0.0; }
    /// The rest, which is counted.
    void lose();

    /// That of the ball; less while it is in a gap that is too narrow for it.
    [[nodiscard]] double radius() const { return m_radius; }
    [[nodiscard]] double skin() const { return m_skin; }
    [[nodiscard]] double rounding() const { return m_rounding; }
    /// From the ball to the surface at least; not positive where that is not known, or where they overlap.
    [[nodiscard]] double room() const { return m_ball.clearance - m_radius; }
    /// Speeds along a contact's direction up to this are none: of a ball that hardly moves, or by the direction's rounding.
    [[nodiscard]] double still() const;
    /// What the directions of contacts may be off by.
    [[nodiscard]] double tilt() const;

    /// Finds the clearance, and what is nearest within a distance from the ball.
    void measure(double reach);
    [[nodiscard]] bool isMeasured() const { return m_isMeasured; }
    /// Whether something was within the reach of the last measure, from where it is now.
    [[nodiscard]] bool hasDirection() const { return m_isMeasured && m_nearest.isFound; }
    /// By the last measure, whether it touches.
    [[nodiscard]] bool isTouching() const;
    [[nodiscard]] const glm::dvec3 &direction() const { return m_nearest.direction; }

    /// Moves under an acceleration, by a way that is no longer than that.
    void advance(double time, const glm::dvec3 &acceleration, double way);
    /// Moves straight on, and has another velocity then.
    void advanceTo(const glm::dvec3 &position, const glm::dvec3 &velocity, double time);
    /// Moves to a place so far away, which nothing was found to be in the way of.
    void moveTo(const glm::dvec3 &position, double distance);
    /// Where it is, so much is proved to be free.
    void setClearance(double clearance);

    /// Makes it stand off the surface; the work is taken from its motion as far as that lasts. Where there is no room it becomes smaller for the step.
    void pushOut();

private:
    /// Along the direction, as far as that is free. Whether it has more room than before.
    bool pushOnce();

    BallState &m_ball;
    const Laws &m_laws;
    Probe &m_probe;
    std::vector<BallPath> *m_paths;
    StepReport m_report;
    double m_time;
    double m_left;
    double m_radius;
    double m_rounding;
    double m_skin;
    Probe::Nearest m_nearest;
    bool m_isMeasured = false;
};

/// Until a ball that goes at v under an acceleration would go back the way it came, at most a time; all of it where it as good
/// as turns now.
[[nodiscard]] double timeForward(const glm::dvec3 &v, const glm::dvec3 &acceleration, double time);

/// v with its length changed for what gravity did on a way beside the one that v was computed for: no energy is won. What is
/// too slow for that stops.
[[nodiscard]] glm::dvec3 withEnergy(const glm::dvec3 &v, double squaredSpeed);

}
