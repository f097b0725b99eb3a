// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "boxbounds.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "fractalgraph.h"

namespace romanesco {

/// How far the fractal reaches along a direction u: the greatest u·x of its points x. Found by SupportSearch, or after
/// looking at `budget` maps and vertices the greatest that is left: hardly more along the axes, where the boxes are
/// tight, and a few per cent elsewhere. -inf for a mesh without faces.
[[nodiscard]] double reachAlong(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &base,
                                const glm::dvec3 &direction, std::size_t budget = 20'000);

/// A box that holds the whole fractal, each side reached as reachAlong() tells. Empty (all zero) for a mesh without
/// faces.
[[nodiscard]] Box extent(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &base,
                         std::size_t budget = 20'000);

}
