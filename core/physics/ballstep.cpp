// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballstep.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Of the radius.
constexpr double skinShare = 1e-4;
/// So many roundings make a skin at least.
constexpr double skinRoundings = 16.0;
/// Of the speed that falling by half the radius gives.
constexpr double stillShare = 1e-7;
/// Of the skin: what is nearer is pushed out, into the middle of it.
constexpr double leastStandOff = 1.0 / 32.0;
constexpr double standOff = 0.5;
constexpr int mostPushes = 8;
/// Of the skin: what a ball in a gap that is too narrow for it may sink in before it touches again.
constexpr double squeeze = 1e-4;
constexpr double mostTilt = 1e-3;
/// Of a time: to turn sooner is not told from rounding, and would be done again and again.
constexpr double leastTurn = 1e-9;

}

BallStep::BallStep(BallState &ball, const Laws &laws, Probe &probe, double time, std::vector<BallPath> *paths)
    : m_ball(ball)
    , m_laws(laws)
    , m_probe(probe)
    , m_paths(paths)
    , m_time(time)
    , m_left(time)
    , m_radius(ball.radius)
    , m_rounding(probe.roundingAt(ball.position))
    , m_skin(std::max(skinShare * ball.radius, skinRoundings * m_rounding))
{
    m_probe.begin(laws.budget);
}

void BallStep::lose()
{
    m_report.isExhausted = true;
    m_left = 0.0;
}

double BallStep::still() const
{
    return stillShare * std::sqrt(glm::length(m_laws.gravity) * m_radius) + 8.0 * tilt() * glm::length(m_ball.velocity);
}

double BallStep::tilt() const
{
    return std::min(mostTilt, m_rounding / m_radius);
}

void BallStep::measure(double reach)
{
    m_nearest = m_probe.nearest(m_ball.position, m_radius + reach);
    m_isMeasured = true;
    m_ball.clearance = m_nearest.clearance;
}

bool BallStep::isTouching() const
{
    return hasDirection() && room() <= m_skin;
}

void BallStep::advance(double time, const glm::dvec3 &acceleration, double way)
{
    if (m_paths != nullptr) {
        m_paths->push_back({m_time - m_left, time, acceleration, m_ball});
    }
    moveTo(m_ball.position + time * m_ball.velocity + (0.5 * time * time) * acceleration, way);
    m_ball.velocity += time * acceleration;
    spend(time);
}

void BallStep::advanceTo(const glm::dvec3 &position, const glm::dvec3 &velocity, double time)
{
    if (m_paths != nullptr && time > 0.0) {
        m_paths->push_back({m_time - m_left, time, glm::dvec3(0.0), m_ball});
        m_paths->back().from.velocity = (position - m_ball.position) / time;
    }
    moveTo(position, glm::distance(position, m_ball.position));
    m_ball.velocity = velocity;
    spend(time);
}

void BallStep::moveTo(const glm::dvec3 &position, double distance)
{
    m_ball.position = position;
    m_ball.clearance = std::max(0.0, m_ball.clearance - distance - m_rounding);
    m_ball.foresight.time = 0.0;
    m_isMeasured = false;
}

void BallStep::setClearance(double clearance)
{
    m_ball.clearance = std::max(m_ball.clearance, clearance - m_rounding);
}

bool BallStep::pushOnce()
{
    const double clearance = m_ball.clearance;
    const glm::dvec3 from = m_ball.position;
    const bool isOnSurface = clearance <= 8.0 * m_rounding;
    const double wanted = isOnSurface ? m_skin : m_radius + standOff * m_skin - clearance;
    const glm::dvec3 way = wanted * m_nearest.direction;
    // where the centre lies on it, nothing can be swept
    const double share = isOnSurface
        ? 1.0
        : m_probe.freeShare(from, way, std::min(m_radius, clearance * (1.0 - 1e-9) - 4.0 * m_rounding));
    moveTo(from + share * way, share * wanted);
    measure(m_skin + m_rounding);
    if (m_ball.clearance > clearance || isOnSurface) {
        return true;
    }
    // something else is as near on the other side
    m_ball.position = from;
    measure(m_skin + m_rounding);
    return false;
}

void BallStep::pushOut()
{
    const double before = glm::dot(m_laws.gravity, m_ball.position);
    for (int push = 0; push < mostPushes && room() < leastStandOff * m_skin && !m_probe.isExhausted(); ++push) {
        if (!pushOnce()) {
            break;
        }
    }
    if (room() < leastStandOff * m_skin) {
        m_radius = std::max(m_rounding, m_ball.clearance - std::max(squeeze * m_skin, 4.0 * m_rounding));
    }
    // what it is lifted by is taken from its motion
    const double won = before - glm::dot(m_laws.gravity, m_ball.position);
    if (won > 0.0) {
        m_ball.velocity = withEnergy(m_ball.velocity, glm::dot(m_ball.velocity, m_ball.velocity) - 2.0 * won);
    }
}

double timeForward(const glm::dvec3 &v, const glm::dvec3 &acceleration, double time)
{
    const double pull = glm::dot(v, acceleration);
    const glm::dvec3 along = v + 0.5 * time * acceleration;
    const bool turns = pull < 0.0 && (glm::dot(v, along) < 0.0 || glm::dot(v + time * acceleration, along) < 0.0);
    const double turn = turns ? -pull / glm::dot(acceleration, acceleration) : time;
    return turn > leastTurn * time ? std::min(time, turn) : time;
}

glm::dvec3 withEnergy(const glm::dvec3 &v, double squaredSpeed)
{
    const double square = glm::dot(v, v);
    if (square <= 0.0 || squaredSpeed <= 0.0) {
        return glm::dvec3(0.0);
    }
    return std::sqrt(std::min(1.0, squaredSpeed / square)) * v;
}

}
