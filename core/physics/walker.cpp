// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "walker.h"

#include <algorithm>
#include <cassert>

#include <glm/geometric.hpp>

#include "ballstepper.h"

namespace romanesco {

namespace {

/// Of the slope that carries: the cosine of 60 degrees.
constexpr double leastUp = 0.5;

}

Walker::Walker(const Surface &surface, const glm::dvec3 &position, double radius)
    : m_probe(surface)
{
    assert(radius > 0.0);
    m_ball.position = position;
    m_ball.radius = radius;
    m_ball.restitution = 0.0;
}

void Walker::go(const glm::dvec3 &way, double seconds, const glm::dvec3 &gravity)
{
    assert(seconds > 0.0);
    const double pull = glm::length(gravity);
    const glm::dvec3 down = pull > 0.0 ? gravity / pull : glm::dvec3(0.0);
    const glm::dvec3 level = way - glm::dot(way, down) * down;
    if (m_isCarried && pull > 0.0 && level == glm::dvec3(0.0)) {
        return;
    }
    m_ball.velocity = level / seconds + m_fall * down;
    // where it goes is not where it went
    m_ball.supports.clear();
    m_ball.isAsleep = false;
    Laws laws;
    laws.gravity = gravity;
    laws.timeStep = seconds;
    stepBall(m_ball, laws, m_probe, seconds);
    m_fall = std::max(0.0, glm::dot(m_ball.velocity, down));
    m_isCarried = std::ranges::any_of(m_ball.supports.directions(),
                                      [&](const glm::dvec3 &n) { return glm::dot(n, down) < -leastUp; });
    m_fall = m_isCarried ? 0.0 : m_fall;
}

}
