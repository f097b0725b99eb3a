// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/collide/bvhcollider.h"
#include "core/fractal/fractalgraph.h"

namespace romanesco::bench {

/// A fractal of tests/data/collide, itself and written out.
struct Workload {
    Mesh mesh;
    FractalGraph graph;
    Mesh all;
    /// Of the box round it.
    double diagonal;
};

/// The fractal of that name, so many levels deep. Ends the program where it cannot be read.
[[nodiscard]] Workload workload(const std::string &name, std::uint64_t depth);

/// How points are asked from: in 1.5 times the bounding box; near the surface, moved along the normal of a random face by
/// 0.1 to 5 % of the diagonal; in pockets, moved away from the surface 12 times inside of 0.9 of the box.
enum class Place { Uniform, Near, Pocket };
constexpr std::array placeNames{"uniform", "near", "pocket"};

/// The same each time. exact is of all faces.
[[nodiscard]] std::vector<glm::dvec3> queries(const Workload &workload, const Collider &exact, Place place);

}
