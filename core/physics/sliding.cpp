// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sliding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "landing.h"

namespace romanesco {

namespace {

/// Of the radius: shorter ways are not tried again where the surface fell away below one.
constexpr double shortWay = 0.5;
/// Of the room that there is, what touches on the way: the rest is for rounding.
constexpr double standOff = 0.75;
/// Of gravity: what is less is rounding.
constexpr double leastPull = 1e-12;
/// Stretches that are of no use are made so much shorter, down to such a share of a time step.
constexpr double shorter = 0.25;
constexpr double leastTime = 1e-9;

class Slide
{
public:
    explicit Slide(BallStep &step)
        : m_step(step)
        , m_ball(step.ball())
    {
    }

    void run()
    {
        if (m_step.room() > m_step.skin()) {
            m_ball.supports.clear(); // it has become smaller
        } else if (m_step.room() <= 0.0) {
            m_step.measure(2.0 * m_step.skin());
            m_step.pushOut();
        }
        while (m_step.left() > 0.0 && !m_ball.supports.isEmpty() && !m_step.probe().isExhausted()) {
            m_pull = pullAlong();
            if (isAtRest()) {
                m_ball.velocity = glm::dvec3(0.0);
                m_ball.isAsleep = true;
                m_step.spend(m_step.left());
                return;
            }
            if (!goOn()) {
                m_step.lose();
                return;
            }
        }
    }

private:
    /// What is left of gravity.
    [[nodiscard]] glm::dvec3 pullAlong() const
    {
        const glm::dvec3 &gravity = m_step.laws().gravity;
        const glm::dvec3 pull = m_ball.supports.allowed(gravity);
        const double least = std::max(leastPull, 8.0 * m_step.tilt()) * glm::length(gravity);
        return glm::length(pull) > least ? pull : glm::dvec3(0.0);
    }

    [[nodiscard]] bool isAtRest() const
    {
        return m_pull == glm::dvec3(0.0) && glm::length(m_ball.velocity) <= m_step.still();
    }

    /// The next stretch, shorter where the surface falls away below a long one. Whether that was of any use.
    bool goOn()
    {
        double time = std::min(timeForward(m_ball.velocity, m_pull, m_step.left()), m_longest);
        for (;; time *= shorter) {
            const glm::dvec3 way = time * m_ball.velocity + (0.5 * time * time) * m_pull;
            const double length = glm::length(way);
            const double stand = standOff * std::min(m_step.room(), m_step.skin());
            if (stand <= 0.0) {
                return false;
            }
            const double share =
                length > 0.0 ? m_step.probe().freeShare(m_ball.position, way, m_step.radius() + stand) : 1.0;
            if (share < 1.0) {
                return goToTouch(time, way, share, m_step.radius() + stand);
            }
            m_longest = std::numeric_limits<double>::infinity();
            if (length > shortWay * m_step.radius() && fallsAway(m_ball.position + way)) {
                continue;
            }
            m_step.advance(time, m_pull, length);
            m_hasLanded = false;
            m_step.setClearance(m_step.radius() + stand);
            m_step.measure(2.0 * m_step.skin());
            const bool isLost = !m_step.isTouching();
            if (isLost) {
                m_ball.supports.clear();
            } else {
                follow(time);
            }
            return true;
        }
    }

    /// Whether nothing is touched at a place, unless that costs too much to ask.
    bool fallsAway(const glm::dvec3 &position)
    {
        const auto nearest = m_step.probe().nearest(position, m_step.radius() + 2.0 * m_step.skin());
        const bool isTouching = nearest.isFound && nearest.clearance <= m_step.radius() + m_step.skin();
        return !isTouching && !m_step.probe().isExhausted();
    }

    /// Where it touches on its way, which is taken as straight: no energy is won by that.
    bool goToTouch(double time, const glm::dvec3 &way, double share, double radius)
    {
        const double length = glm::length(way);
        const glm::dvec3 along = way / length;
        const double speed = glm::dot(m_ball.velocity, along);
        const double pull = glm::dot(m_pull, along);
        const double gone = share * length;
        const double sum = speed + std::sqrt(std::max(0.0, speed * speed + 2.0 * pull * gone));
        const double spent = sum > 0.0 ? std::min(time, 2.0 * gone / sum) : 0.0;
        const double square = glm::dot(m_ball.velocity, m_ball.velocity);
        if (gone > 0.0) {
            const glm::dvec3 velocity =
                withEnergy(m_ball.velocity + spent * m_pull, square + 2.0 * share * glm::dot(m_pull, way));
            m_step.advanceTo(m_ball.position + share * way, velocity, spent);
            m_step.setClearance(radius);
            m_hasLanded = false;
        }
        m_step.measure(2.0 * m_step.skin());
        if (!m_step.isTouching()) {
            m_ball.supports.clear();
            return true;
        }
        m_step.pushOut();
        const unsigned contacts = m_step.report().contacts;
        land(m_step);
        // what it lies against answers again and again
        const bool hasLanded = m_step.report().contacts > contacts && !std::exchange(m_hasLanded, true);
        // It goes away from what it touched and is pulled back to it on the way.
        const bool isPulledBack = !hasLanded && !settle(m_step);
        m_longest = isPulledBack ? shorter * time : std::numeric_limits<double>::infinity();
        return gone > 0.0 || hasLanded || time > leastTime * m_step.laws().timeStep;
    }

    /// Turns with the surface that it lies against, or leaves it.
    void follow(double time)
    {
        m_step.pushOut();
        if (m_ball.supports.count() > 1) {
            findSupports(m_step);
            landWhereAgainst();
            return;
        }
        const glm::dvec3 n = m_step.direction();
        const double along = glm::dot(m_ball.velocity, n);
        const double held = std::max(0.0, -glm::dot(m_step.laws().gravity, n)) * time + m_step.still();
        if (along < -m_step.still()) {
            land(m_step);
        } else if (along <= held) {
            const double square = glm::dot(m_ball.velocity, m_ball.velocity);
            const glm::dvec3 turned = m_ball.velocity - along * n;
            const double length = glm::length(turned);
            m_ball.velocity = length > 0.0 ? std::sqrt(square) / length * turned : glm::dvec3(0.0);
            m_ball.supports.clear();
            m_ball.supports.add(n);
            ++m_step.report().contacts;
        } else {
            m_ball.supports.clear();
        }
    }

    void landWhereAgainst()
    {
        const bool isAgainst = std::ranges::any_of(m_ball.supports.directions(), [&](const glm::dvec3 &n) {
            return glm::dot(m_ball.velocity, n) < -m_step.still();
        });
        if (isAgainst) {
            land(m_step);
        }
    }

    BallStep &m_step;
    BallState &m_ball;
    glm::dvec3 m_pull{0.0};
    /// Where it is.
    bool m_hasLanded = false;
    /// What is tried next.
    double m_longest = std::numeric_limits<double>::infinity();
};

}

void slide(BallStep &step)
{
    Slide(step).run();
}

}
