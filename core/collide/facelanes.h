// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/affinemap.h"
#include "core/geometry/mesh.h"
#include "core/geometry/movingsphere.h"
#include "lanes.h"

namespace romanesco {

/// Triangles, with what the way to each from a point is found by.
struct alignas(64) FaceLanes {
    LanesOfPoint a;
    /// From a to b, from a to c and from b to c; each by the square of its length besides, or 0.
    std::array<LanesOfPoint, 3> edges;
    std::array<LanesOfPoint, 3> perSquare;
    /// The shares of b and c in a point's foot on the plane are these, times the way from a.
    std::array<LanesOfPoint, 2> shares;
    /// Of length 1.
    LanesOfPoint normal;
    /// Not 0 where distances are as faceDistances() says: not of needles, of what is hardly a triangle, and of sizes beyond
    /// 1e-70 and 1e70.
    Lanes isPlain;
};

/// The corners of faces, 8 at a time; those left over repeat the last.
struct alignas(64) CornerLanes {
    std::array<LanesOfPoint, 3> corners;
};
[[nodiscard]] std::vector<CornerLanes> cornersOf(const Mesh &mesh);

/// What a map makes of faces.
void placeFaces(std::span<const CornerLanes> corners, const AffineMap &map, FaceLanes *faces);

/// From p to each triangle that is plain, off by at most `errorOfFaceDistances` times the largest coordinate of the way
/// from p to any of its corners. The nearest of the three edges, unless the foot on the plane is inside.
void faceDistances(std::span<const FaceLanes> faces, const glm::dvec3 &p, double *distances);
constexpr double errorOfFaceDistances = 0x1p-46;

/// How far a sphere, which starts at p and touches nothing before a way, comes before it touches each triangle: never more
/// than it is but for rounding, as if the radius were less by 64 units in the last place of the largest coordinate of a
/// corner, seen from p, or of the radius. Infinite where it never touches. Within a thousandth of the radius for most that
/// are plain, or beyond `until`.
void waysToFaces(std::span<const FaceLanes> faces, const glm::dvec3 &p, const MovingSphere &sphere, double from,
                 double until, double *ways);

}
