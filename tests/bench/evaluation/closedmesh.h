// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>

#include "core/geometry/mesh.h"

namespace romanesco::bench {

/// What a closed mesh looks like.
enum class Form {
    Boulder, ///< dented, twisted about its height and bent
    Stump,   ///< a stem with roots that flare and bark of furrows, turned and bent a little
};

/// A closed surface of so many triangles, an even number from 4 on: the convex hull of points that lie on a sphere by
/// chance, so that it is no grid, moved to and fro along their radii, which makes no face pass through another, and warped
/// with the space that it is in. The same each time. Costs a second where faces are some hundred thousand.
[[nodiscard]] Mesh closedMesh(std::uint32_t faces, Form form);

/// What keeps a mesh from being one closed surface without holes through it, its faces looking outwards and each vertex
/// used: a sentence; empty for one that is.
[[nodiscard]] std::string flawOf(const Mesh &mesh);

}
