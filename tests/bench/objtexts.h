// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string>

namespace romanesco {

/// What stands in a generated OBJ file.
enum class ObjStyle {
    /// Six decimals, texture coordinates and normals at every corner: what modelling programs export.
    Export,
    /// Vertices of 17 digits, and faces: what programs that compute write.
    Exact,
};

/// An OBJ text of a closed surface of so many triangles (even, at least 8): a Delaunay triangulation of random points
/// on a sphere, each inserted into a random triangle, then bulged and jittered. No two neighbourhoods are alike. The same
/// arguments give the same text.
[[nodiscard]] std::string objText(std::size_t faces, ObjStyle style);

}
