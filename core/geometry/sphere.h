// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "affinemap.h"

namespace romanesco {

/// A closed ball; a negative radius is the empty set.
struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = -1.0;

    [[nodiscard]] bool isEmpty() const { return radius < 0.0; }
};

/// A sphere that holds map(sphere); norm is operatorNorm(map.linear), kept by the caller. Grown by a rounding bound.
[[nodiscard]] Sphere transformed(const AffineMap &map, double norm, const Sphere &sphere);

/// The radius that a sphere round centre needs to hold all the spheres; -1 for none.
[[nodiscard]] double enclosingRadius(const glm::dvec3 &centre, std::span<const Sphere> spheres);

/// A sphere that holds all the spheres (empty ones left out), within about 5 % of the smallest:
/// Bădoiu and Clarkson 2003 from the middle of the bounding box, with 48 steps, fewer for more than 4,000 spheres.
/// Cost: two distances a sphere and step.
[[nodiscard]] Sphere enclosingSphere(std::span<const Sphere> spheres);

/// A sphere that holds all the points, made in the same way.
[[nodiscard]] Sphere enclosingSphere(std::span<const glm::dvec3> points);

/// Whether outer holds inner, rounding counted against it.
[[nodiscard]] bool contains(const Sphere &outer, const Sphere &inner);

}
