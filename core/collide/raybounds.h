// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>

#include <glm/vec3.hpp>

#include "core/geometry/affinemap.h"
#include "core/geometry/box.h"
#include "core/geometry/sphere.h"

/// Where a ray from the origin, whose direction has length 1, is within what bounds something.
namespace romanesco {

/// From one way along a ray to another, which may be behind the origin; nothing where `from` is greater.
struct WaySpan {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();

    [[nodiscard]] static WaySpan ofNothing() { return {.from = std::numeric_limits<double>::infinity()}; }
    [[nodiscard]] bool isEmpty() const { return !(from <= to); }
};

/// Within a sphere; some units in the last place of its centre's distance may be missing.
[[nodiscard]] WaySpan waysWithin(const Sphere &sphere, const glm::dvec3 &direction);

/// A ray seen from a frame that an affine map places, of any kind: the map's adjugate takes the ray there without
/// dividing, so that a flat map only leaves fewer planes that bound anything.
class RayInFrame
{
public:
    /// error: how far off points are that the map places, beside this map's own rounding.
    RayInFrame(const AffineMap &map, const glm::dvec3 &direction, double error);

    /// Never less than the ways at which the ray is in what the map makes of a box.
    [[nodiscard]] WaySpan waysWithin(const Box &box) const;

private:
    /// Of the frame's three coordinates, each times the map's determinant, along the ray: start + way·step.
    glm::dvec3 m_start{0.0};
    glm::dvec3 m_step{0.0};
    double m_determinant = 0.0;
    /// What they may be off by, for each unit by which points are off; and the points themselves by so much, and more for
    /// each unit of the frame's coordinates.
    glm::dvec3 m_sensitivity{0.0};
    double m_error = 0.0;
    double m_errorOfReach = 0.0;
};

}
