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

glm::dmat3 rotationFrom(const CosSin &x, const CosSin &y, const CosSin &z)
{
    const glm::dmat3 pitch = fromRows({1, 0, 0}, {0, x.cosine, x.sine}, {0, -x.sine, x.cosine});
    const glm::dmat3 yaw = fromRows({y.cosine, 0, -y.sine}, {0, 1, 0}, {y.sine, 0, y.cosine});
    const glm::dmat3 roll = fromRows({z.cosine, z.sine, 0}, {-z.sine, z.cosine, 0}, {0, 0, 1});
    return pitch * yaw * roll;
}

/// Of angles within an eighth of a turn. The C library's own differ from one version, and one processor, to another in the
/// last digit, and all that stands on a turned surface with them. Taylor's series: what is left out is below 2^-63.
CosSin cosSinOfSmall(double radians)
{
    constexpr int last = 18;
    const double square = radians * radians;
    double cosine = 0.0;
    double sine = 0.0;
    for (int i = last; i > 2; i -= 2) {
        cosine = square * (1.0 - cosine) / (i * (i - 1));
        sine = square * (1.0 - sine) / (i * (i + 1));
    }
    return {1.0 - (0.5 * square - 0.5 * square * cosine), radians - radians * (square * (1.0 - sine) / 6.0)};
}

/// Closer to straight up nothing is left of the angle about that axis.
constexpr double leastLevel = 1e-12;

}

CosSin cosSinOfDegrees(double degrees)
{
    // fmod is exact, and so is the subtraction of a near multiple of 90: no rounding before the radians.
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = std::nearbyint(turn / 90.0);
    const double radians = (turn - 90.0 * quarters) * (std::numbers::pi / 180.0);
    const auto [c, s] = cosSinOfSmall(radians);
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
    return rotationFrom(cosSinOfDegrees(degrees.x), cosSinOfDegrees(degrees.y), cosSinOfDegrees(degrees.z));
}

glm::dmat3 rotationFromRadians(const glm::dvec3 &radians)
{
    const auto of = [](double angle) { return CosSin{std::cos(angle), std::sin(angle)}; };
    return rotationFrom(of(radians.x), of(radians.y), of(radians.z));
}

glm::dvec3 radiansOf(const glm::dmat3 &rotation)
{
    const auto at = [&](int row, int column) { return rotation[column][row]; };
    const double level = std::hypot(at(0, 0), at(0, 1));
    const double yaw = std::atan2(-at(0, 2), level);
    if (level < leastLevel) {
        return {std::atan2(std::copysign(at(1, 0), at(1, 0) * yaw), at(1, 1)), yaw, 0.0};
    }
    return {std::atan2(at(1, 2), at(2, 2)), yaw, std::atan2(at(0, 1), at(0, 0))};
}

}
