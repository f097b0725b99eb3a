// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "faceranking.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/triangledistance.h"
#include "nearest.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Squares above have all their digits, and those far below are still numbers.
constexpr double leastSquare = 0x1p-600;
/// A squared distance to a box is off by 6 roundings at most, its root by 3 and one of its own.
constexpr double roundedDown = 1.0 - 0x1p-50;
/// Twice that of distanceTo(), as a share of the farthest coordinate.
constexpr double errorOfDistances = 0x1p-47;

double farthest(const glm::dvec3 &p, const Box &box)
{
    const glm::dvec3 reach = glm::max(p - box.least, box.greatest - p);
    return std::max({reach.x, reach.y, reach.z});
}

double squared(double x)
{
    return x * x;
}

Box boxOf(const Triangle &triangle)
{
    return Box{triangle[0], triangle[0]}.with(triangle[1]).with(triangle[2]);
}

}

void FaceRanking::begin(const glm::dvec3 &p, double radius, const Box &around, const std::optional<glm::dvec3> &motion)
{
    assert(radius >= 0.0 && "distances are not negative");
    assert(std::isfinite(p.x + p.y + p.z) && "no face is nearest to a point that is nowhere");
    m_p = p;
    m_motion = motion;
    m_distance = radius;
    m_face = none;
    m_facesShown = 0;
    m_lower = infinity;
    m_droppedSquare = infinity;
    const double reach = farthest(p, around);
    setUnits(std::min(radius, reach));
    m_best = squared((radius + errorOfDistances * reach) * m_perUnit);
}

void FaceRanking::setUnits(double distance)
{
    const int exponent = distance > 0.0 ? std::clamp(-std::ilogb(distance), -1022, 1022) : 1022;
    m_perUnit = std::ldexp(1.0, exponent);
}

double FaceRanking::squareTo(const Box &box) const
{
    const glm::dvec3 before = box.least - m_p;
    const glm::dvec3 behind = m_p - box.greatest;
    const glm::dvec3 offset = glm::max(glm::max(before, behind), glm::dvec3(0.0)) * m_perUnit;
    return glm::dot(offset, offset);
}

void FaceRanking::show(std::uint32_t face)
{
    ++m_facesShown;
    const Triangle triangle = triangleOf(m_mesh, face);
    std::optional<TriangleDistance> found = quickDistance(triangle, m_p);
    if (!found) {
        if (drops(squareTo(boxOf(triangle)))) {
            return;
        }
        found = distanceTo(triangle, m_p);
    }
    if (m_motion && !isAhead(closestPoint(triangle, m_p).point, triangle, m_p, m_motion)) {
        return;
    }
    m_lower = std::min(m_lower, found->distance - found->error);
    if (squared(found->distance * m_perUnit) > m_best) {
        return;
    }
    const double rank = rankOf(triangle, found->distance);
    if (rank < m_best || (rank == m_best && face < m_face)) {
        m_best = rank;
        m_distance = found->distance;
        m_face = face;
        if (rank < leastSquare) {
            refineUnits(triangle);
        }
    }
}

/// Where squares of the best distance have few digits.
void FaceRanking::refineUnits(const Triangle &best)
{
    m_lower = lower();
    m_droppedSquare = infinity;
    setUnits(m_distance);
    m_best = rankOf(best, m_distance);
}

double FaceRanking::rankOf(const Triangle &triangle, double distance) const
{
    return std::max(squared(distance * m_perUnit), squareTo(boxOf(triangle)));
}

double FaceRanking::lower() const
{
    const double dropped = std::sqrt(m_droppedSquare) / m_perUnit * roundedDown;
    return std::max(std::min(m_lower, dropped), 0.0);
}

}
