// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ball.h"
#include "probe.h"

namespace romanesco {

/// A sphere that goes where it is told, as far as a surface lets it: it slides along what is in its way and enters nothing.
/// Where there is gravity it falls until something carries it. The dissertation's simple player.
class Walker
{
public:
    /// surface must outlive it; radius is above 0.
    Walker(const Surface &surface, const glm::dvec3 &position, double radius);

    /// Goes a way in a time above 0, without bouncing; it stands still where it is carried and has no way to go. Where gravity
    /// pulls it counts the way beside that alone. Cost: that of a step of a ball.
    void go(const glm::dvec3 &way, double seconds, const glm::dvec3 &gravity);

    [[nodiscard]] const glm::dvec3 &position() const { return m_ball.position; }
    [[nodiscard]] double radius() const { return m_ball.radius; }
    /// By the last way: something not too steep is below it.
    [[nodiscard]] bool isCarried() const { return m_isCarried; }

private:
    Probe m_probe;
    BallState m_ball;
    /// How fast it falls.
    double m_fall = 0.0;
    bool m_isCarried = false;
};

}
