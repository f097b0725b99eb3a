// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "rotation.h"

#include <cmath>
#include <numbers>

namespace romanesco {

namespace {

/// A matrix from its rows, as it is written on paper (glm's constructor takes columns).
glm::dmat3 fromRows(const glm::dvec3 &a, const glm::dvec3 &b, const glm::dvec3 &c)
{
    return {a.x, b.x, c.x, a.y, b.y, c.y, a.z, b.z, c.z};
}

}

CosSin cosSinOfDegrees(double degrees)
{
    // fmod is exact, and so is the subtraction of a near multiple of 90: no rounding before the radians.
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = std::nearbyint(turn / 90.0);
    const double radians = (turn - 90.0 * quarters) * (std::numbers::pi / 180.0);
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    switch ((static_cast<int>(quarters) % 4 + 4) % 4) {
    case 0:
        return {c, s};
    case 1:
        return {-s, c};
    case 2:
        return {-c, -s};
    default:
        return {s, -c};
    }
}

glm::dmat3 rotationFromDegrees(const glm::dvec3 &degrees)
{
    const auto [cx, sx] = cosSinOfDegrees(degrees.x);
    const auto [cy, sy] = cosSinOfDegrees(degrees.y);
    const auto [cz, sz] = cosSinOfDegrees(degrees.z);
    const glm::dmat3 pitch = fromRows({1, 0, 0}, {0, cx, sx}, {0, -sx, cx});
    const glm::dmat3 yaw = fromRows({cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy});
    const glm::dmat3 roll = fromRows({cz, sz, 0}, {-sz, cz, 0}, {0, 0, 1});
    return pitch * yaw * roll;
}

}
