// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include "core/geometry/movingsphere.h"
#include "lanes.h"

namespace romanesco {

/// How far a sphere, which starts at p, comes before it touches each of the boxes, never more than it is but for rounding;
/// infinite where it never does. Within 1e-5 of the radius in all but a few cases.
void waysTo(std::span<const TurnedBoxes> boxes, const glm::dvec3 &p, const MovingSphere &sphere, double *ways);

/// The same for what a map makes of each, seen from where the sphere starts, but less well: for the boxes round them grown
/// by the radius, as wayToBox().
void waysTo(std::span<const Parallelepipeds> boxes, const AffineMap &map, const MovingSphere &sphere, double *ways);

/// Puts in how far the sphere, having come so far already, comes before it touches each hull, as a plane across the way to
/// its centre proves, where that is farther. Nothing where ways are infinite.
void raiseToHulls(const HullsOfFew &hulls, const glm::dvec3 &p, const MovingSphere &sphere, double *ways);
/// The same for what a map makes of each, whose norm is no greater, seen from where the sphere starts.
void raiseToHulls(const HullsOfFew &hulls, const AffineMap &map, double norm, const MovingSphere &sphere, double *ways);

}
