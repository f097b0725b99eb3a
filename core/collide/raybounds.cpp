// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "raybounds.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Of the sums of a few products that an adjugate is made of, and of the point that they are taken of.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Where least <= start + way·step <= greatest.
WaySpan between(double least, double greatest, double start, double step)
{
    if (step == 0.0) {
        return least <= start && start <= greatest ? WaySpan{} : WaySpan::ofNothing();
    }
    const double first = (least - start) / step;
    const double second = (greatest - start) / step;
    return {std::min(first, second), std::max(first, second)};
}

}

WaySpan waysWithin(const Sphere &sphere, const glm::dvec3 &direction)
{
    const double middle = glm::dot(sphere.centre, direction);
    const glm::dvec3 across = sphere.centre - middle * direction;
    const double square = sphere.radius * sphere.radius - glm::dot(across, across);
    if (!(square >= 0.0) || sphere.isEmpty()) {
        return WaySpan::ofNothing();
    }
    const double half = std::sqrt(square);
    return {middle - half, middle + half};
}

RayInFrame::RayInFrame(const AffineMap &map, const glm::dvec3 &direction, double error)
{
    const glm::dmat3 &linear = map.linear;
    const glm::dvec3 lengths(glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2]));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 normal = glm::cross(linear[(i + 1) % 3], linear[(i + 2) % 3]);
        m_start[i] = -glm::dot(normal, map.translation);
        m_step[i] = glm::dot(normal, direction);
        m_sensitivity[i] = lengths[(i + 1) % 3] * lengths[(i + 2) % 3];
    }
    m_determinant = glm::dot(linear[0], glm::cross(linear[1], linear[2]));
    m_error = error + rounding * glm::length(map.translation);
    m_errorOfReach = rounding * (lengths.x + lengths.y + lengths.z);
}

WaySpan RayInFrame::waysWithin(const Box &box) const
{
    const glm::dvec3 reach = glm::max(glm::abs(box.least), glm::abs(box.greatest));
    const double error = m_error + m_errorOfReach * std::max({reach.x, reach.y, reach.z});
    WaySpan ways;
    for (int i = 0; i < 3; ++i) {
        const double one = m_determinant * box.least[i];
        const double other = m_determinant * box.greatest[i];
        const double margin = m_sensitivity[i] * error;
        const WaySpan ofAxis =
            between(std::min(one, other) - margin, std::max(one, other) + margin, m_start[i], m_step[i]);
        ways = {std::max(ways.from, ofAxis.from), std::min(ways.to, ofAxis.to)};
    }
    return ways;
}

}
