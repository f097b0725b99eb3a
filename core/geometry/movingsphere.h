// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "affinemap.h"
#include "box.h"
#include "closestpoint.h"

/// How far a moving sphere comes before it touches what is convex. All is seen from where its centre starts, and ways are
/// lengths. u is 2^-53.
///
/// The distance to a convex body is a convex function of the way, and planes that have the body behind them are its
/// tangents: Newton's method with them never goes too far, and a plane that the sphere does not come nearer to proves
/// that it misses (conservative advancement; Mirtich 1996).
namespace romanesco {

/// A sphere that moves from the origin.
struct MovingSphere {
    /// Of length 1; 0 where it rests.
    glm::dvec3 direction{0.0};
    double radius = 0.0;
};

/// A plane that a body is beyond: normal·y is at least offset for all its points. The normal has length 1; 0 proves nothing.
struct SupportPlane {
    glm::dvec3 normal{0.0};
    double offset = 0.0;

    /// Before which the sphere, which has come so far, does not touch anything beyond; infinite where it never does.
    [[nodiscard]] double wayOf(const MovingSphere &sphere, double from) const;
};

/// Bodies. planeFrom(): a plane between a point and the body, across the way from one to the other, or nearly. It holds
/// but for some units in the last place of the coordinates, however far off the way is.
struct BoxBody {
    Box box;
    [[nodiscard]] SupportPlane planeFrom(const glm::dvec3 &point) const;
};
struct ParallelepipedBody {
    glm::dvec3 middle{0.0};
    /// From the middle.
    std::array<glm::dvec3, 3> halfEdges{};
    [[nodiscard]] SupportPlane planeFrom(const glm::dvec3 &point) const;
    /// The box round it.
    [[nodiscard]] Box box() const;
};
/// What a map makes of a box.
[[nodiscard]] ParallelepipedBody parallelepiped(const AffineMap &map, const Box &box);
/// The hull of corners, of which there is one at least, and what is within an error of it.
struct HullBody {
    std::span<const glm::dvec3> corners;
    double error = 0.0;
    [[nodiscard]] SupportPlane planeFrom(const glm::dvec3 &point) const;
};

/// Before which the sphere does not touch a box: until its centre is in the box grown by the radius, so never more than it
/// is, but for rounding. Infinite where it never does. A dozen nanoseconds.
[[nodiscard]] double wayToBox(const Box &box, const MovingSphere &sphere);

/// The same for any body, from a way at which it is not touched, within 1e-5 of the radius in all but a few cases; or beyond
/// `until`.
template<typename Body>
[[nodiscard]] double wayTo(const Body &body, const MovingSphere &sphere, double from, double until)
{
    constexpr int mostSteps = 24;
    const double closeEnough = 1e-4 * sphere.radius;
    double way = from;
    for (int step = 0; step < mostSteps && way < until; ++step) {
        const SupportPlane plane = body.planeFrom(way * sphere.direction);
        const double before = std::exchange(way, plane.wayOf(sphere, way));
        // where it nearly glides along, even a long step may end far from a touch
        if (way - before <= closeEnough * std::max(0.0, glm::dot(plane.normal, sphere.direction))) {
            break;
        }
    }
    return way;
}

/// The first touch of a sphere and a triangle.
struct TriangleTouch {
    /// The sphere does not touch the triangle before; infinite where it never does.
    double way = std::numeric_limits<double>::infinity();
    /// Whether it touches there; else no more is known, since it is beyond what was asked for.
    bool isTouch = false;
};

/// Where a sphere touches a triangle first, of any shape (see closestPoint()), unless it is beyond `until`; from a way
/// before which it does not.
///
/// With M the greatest coordinate of a vertex, or the radius if that is more: before `way` no point of the triangle is
/// within the radius, though each coordinate of the vertices be off by u of itself and the direction's length by 2·u; and
/// there the triangle is within the radius and 128·u·M. So a sphere that passes at its radius touches or misses as
/// rounding has it only if it is no more than that too far, and what is within the radius is never missed. (The worst
/// of 20,000 measured: 61.)
///
/// Each step costs as quickDistance(); there are three to six, ten where it grazes, and never more than 200.
/// Precondition: coordinates and radius are finite and at most 1e150. Thread-safe.
[[nodiscard]] TriangleTouch touch(const Triangle &triangle, const MovingSphere &sphere, double from = 0.0,
                                  double until = std::numeric_limits<double>::infinity());

/// Of what a sphere touches at a way.
struct Contact {
    glm::dvec3 point{0.0};
    /// Of length 1: from the point to the sphere's centre; where both are one place but for rounding that of the triangle's
    /// face which looks against the motion, or against the motion where it has none, or up where the sphere rests.
    glm::dvec3 direction{0.0, 1.0, 0.0};
};
[[nodiscard]] Contact contactAt(double way, const Triangle &triangle, const MovingSphere &sphere);

}
