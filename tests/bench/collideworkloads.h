// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/collide/collider.h"
#include "core/fractal/boxbounds.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"

namespace romanesco::bench {

/// A fractal of tests/data/collide.
struct Workload {
    Mesh mesh;
    FractalGraph graph;
    BoxBounds boxes;
    /// What the graph and the boxes took to build.
    double seconds;
    /// Written out; without faces where it is not.
    Mesh all;
    Box box;
    /// Of the box.
    double diagonal;
};

/// The fractal of that name, so many levels deep. Ends the program where it cannot be read.
[[nodiscard]] Workload workload(const std::string &name, std::uint64_t depth);

/// The same, not written out, at any depth. Its box is wider by half a per cent.
[[nodiscard]] Workload deepWorkload(const std::string &name, std::uint64_t depth);

void append(Mesh &all, const Mesh &mesh, const AffineMap &map);

/// How points are asked from: in 1.5 times the bounding box; near the surface, moved along the normal of a random face by
/// 0.1 to 5 % of the diagonal; in pockets, moved away from the surface 12 times inside of 0.9 of the box.
enum class Place { Uniform, Near, Pocket };
constexpr std::array placeNames{"uniform", "near", "pocket"};

/// The same each time. exact is of all faces. A random face of a fractal that is not written out is found by random picks,
/// to the end.
[[nodiscard]] std::vector<glm::dvec3> queries(const Workload &workload, const Collider &exact, Place place);

}
