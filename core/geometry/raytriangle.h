// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>

#include "closestpoint.h"

namespace romanesco {

/// A ray from the origin that meets triangles, so that none slips through between those that share an edge or a corner:
/// Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection". Corners are sheared along the ray into a plane
/// across it, each by itself, and there the signs of three areas tell. A computed sign is never the opposite of the true
/// one, only 0 at times, which counts as inside; so what is sheared is covered without a gap.
///
/// With u = 2^-53 and M the greatest coordinate of a corner: a triangle is met or missed as one whose corners are moved
/// across the ray by 4·u·M, and one that the ray passes within such a distance may be met as well.
class RayOnTriangles
{
public:
    /// Of length 1, but for rounding.
    explicit RayOnTriangles(const glm::dvec3 &direction);

    /// How far it is to the triangle, seen from either side; below 0 behind the origin. Nothing where the ray misses, or
    /// runs along the face. Never before the nearest corner or behind the farthest but for rounding, and off by
    /// 16·u·M·(1 + D/h) at most: D is how far the triangle reaches along the ray, h its least height as the ray sees it.
    /// Precondition: coordinates are at most 1e150.
    [[nodiscard]] std::optional<double> wayTo(const Triangle &triangle) const;

private:
    /// The axis that the ray is nearest to, and the other two.
    std::array<int, 3> m_axes{};
    /// What a step along that axis is along the others, and along the ray.
    glm::dvec3 m_shear{0.0};
};

}
