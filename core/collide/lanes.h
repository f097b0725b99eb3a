// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include "core/geometry/affinemap.h"

/// What the search of colliders computes of many things at once, in the widest vectors that the processor has. Each
/// number is computed as it would be by itself, a product and then a sum, so that results are the same bits everywhere.
namespace romanesco {

/// Numbers of eight things, side by side.
constexpr std::size_t laneCount = 8;
using Lanes = std::array<double, laneCount>;
using LanesOfPoint = std::array<Lanes, 3>;

/// Blocks for so many things.
constexpr std::size_t blocksFor(std::size_t count)
{
    return (count + laneCount - 1) / laneCount;
}

inline void setLane(LanesOfPoint &lanes, std::size_t lane, const glm::dvec3 &v)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lanes[axis][lane] = v[static_cast<int>(axis)];
    }
}

/// Boxes, each in a frame that p is turned into: p there is turned·p + offset, seen from the middle of the box.
struct alignas(64) TurnedBoxes {
    /// Rows.
    std::array<LanesOfPoint, 3> turned{};
    LanesOfPoint offset{};
    LanesOfPoint half{};
};

/// Parallelepipeds: the middle and three half edges.
struct alignas(64) Parallelepipeds {
    LanesOfPoint middle{};
    std::array<LanesOfPoint, 3> edges{};
};

/// From p to each of the boxes, or 0 inside.
void distancesTo(std::span<const TurnedBoxes> boxes, const glm::dvec3 &p, double *distances);

/// From the origin to what a map makes of each, never more than it is but for rounding: for any direction x no point of a
/// parallelepiped is nearer than (x·middle − Σ|x·edge|)/|x|. x is the nearest point, nearly: from the middle two rounds
/// along the edges.
void distancesTo(std::span<const Parallelepipeds> boxes, const AffineMap &map, double *distances);

/// The number of the first least. There is one, and none is NaN.
[[nodiscard]] std::size_t leastOf(std::span<const double> numbers);

/// Which of some points, eight at a time, is the first that is least along a direction.
[[nodiscard]] std::size_t leastAlong(std::span<const LanesOfPoint> points, const glm::dvec3 &direction);

/// Convex hulls of few corners. No point of one is farther from its corners than the error.
struct alignas(64) HullsOfFew {
    static constexpr std::size_t cornerCount = 16;
    LanesOfPoint centre;
    /// Seen from the centre, as many as any of them has; those that one lacks repeat its first.
    std::array<LanesOfPoint, cornerCount> corners;
    Lanes error;
    std::size_t cornersUsed;
};

/// Puts in how far from p each hull begins, as seen along the way to its centre, where that is farther.
void raiseToHulls(const HullsOfFew &hulls, const glm::dvec3 &p, double *distances);
/// The same from the origin to what a map makes of each, whose norm is no greater.
void raiseToHulls(const HullsOfFew &hulls, const AffineMap &map, double norm, double *distances);

}
