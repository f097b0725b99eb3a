// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace romanesco {

/// The convex hull of some points, by its corners, and how far outside it something may be that it stands for. Of nothing
/// without corners.
struct Hull {
    std::vector<glm::dvec3> corners;
    double error = 0.0;

    [[nodiscard]] bool isEmpty() const { return corners.empty(); }
};

/// Bounds of a distance.
struct HullDistance {
    double least = 0.0;
    double greatest = 0.0;
};

/// From p to the convex hull of points, of which there must be one. Gilbert, Johnson and Keerthi 1988; least is proved by
/// a plane across the way to the point that was found, so that it holds but for rounding whatever was found; the two
/// seldom differ by more than 1e-12 of the distance. Cost: half a dozen products for each point and some hundred
/// nanoseconds. Coordinates up to 1e150.
[[nodiscard]] HullDistance distanceToHull(std::span<const glm::dvec3> points, const glm::dvec3 &p);

/// A hull with at most so many corners, each one of the points, the next always the one that is farthest outside; the
/// points are within its error. Fewer where more corners make no difference above the tolerance.
[[nodiscard]] Hull thinned(std::span<const glm::dvec3> points, std::size_t mostCorners, double tolerance);

}
