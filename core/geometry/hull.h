// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <limits>
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

/// Bounds of a distance, and the way to a point that is as far as the greater one.
struct HullDistance {
    double least = 0.0;
    double greatest = 0.0;
    glm::dvec3 way{0.0};
};

/// From p to the convex hull of points, of which there must be one. Gilbert, Johnson and Keerthi 1988; least is proved by
/// a plane across the way to the point that was found, so that it holds but for rounding whatever was found; the two
/// seldom differ by more than 1e-12 of the distance. Cost: some steps of half a dozen products for each point and a
/// hundred nanoseconds. Where it is proved to be above `enough` it is not looked at more closely. Coordinates up to 1e150.
[[nodiscard]] HullDistance distanceToHull(std::span<const glm::dvec3> points, const glm::dvec3 &p,
                                          double enough = std::numeric_limits<double>::infinity());

/// Points that are known by which of them is least along a direction.
class PointsByDirection
{
public:
    [[nodiscard]] virtual glm::dvec3 leastAlong(const glm::dvec3 &direction) const = 0;

protected:
    ~PointsByDirection() = default;
};

/// From the origin to the convex hull of points, of which `first` is one.
[[nodiscard]] HullDistance distanceToHull(const glm::dvec3 &first, const PointsByDirection &points,
                                          double enough = std::numeric_limits<double>::infinity());

/// A hull with at most so many corners, each one of the points, the next always the one that is farthest outside; the
/// points are within its error. Fewer where more corners make no difference above the tolerance.
[[nodiscard]] Hull thinned(std::span<const glm::dvec3> points, std::size_t mostCorners, double tolerance);

}
