// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace romanesco {

using Triangle = std::array<glm::dvec3, 3>;

/// The closest point of something to a point p, with what is proved of it. u is 2^-53.
struct ClosestPoint {
    glm::dvec3 point{0.0};
    /// From p to the point.
    double distance = 0.0;
    /// No point is nearer to p than this.
    double lower = 0.0;
};

/// The closest point of a triangle to p, whatever its shape: a needle, a segment written as a triangle, a single point.
/// With M the greatest distance along an axis from p to a vertex, distance − lower is at most 32·u·M, and the point is
/// within 8·u·M of the triangle (and an ulp of its own size, as it is rounded).
///
/// Solved in double: the three edges and the plane each give a point of the triangle, and the nearest is taken. What
/// was found is then certified by planes: for any unit vector n, no point of the triangle is nearer than the least of
/// n·(vertex − p). Those are tried: along the answer, along the normal, and along what of the answer is across an edge.
/// Where the two still differ by more it is solved again with 113 bits (one in 25,000 of needles seen from nearby; some
/// 100 times the cost).
///
/// Precondition: all coordinates are finite and at most 1e300. Thread-safe.
[[nodiscard]] ClosestPoint closestPoint(const Triangle &triangle, const glm::dvec3 &p);

/// The direction from p across which a plane proves that `lower`: no n·(vertex − p) is below it, but for 16·u·M. Of
/// length 1; 0 where nothing above 0 is proved. Cost and preconditions are those of closestPoint().
[[nodiscard]] glm::dvec3 separatingDirection(const Triangle &triangle, const glm::dvec3 &p);

}
