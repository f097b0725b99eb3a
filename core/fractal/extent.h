// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "fractalgraph.h"

namespace romanesco {

/// How far the fractal reaches along a direction u: the greatest u·x of its points x, or a few per cent of its size more.
/// A best-first search over the states' spheres, which ends with the answer or after looking
/// at `budget` copies with the largest bound that is left. -inf for a mesh without faces.
[[nodiscard]] double reachAlong(const FractalGraph &graph, const Mesh &base, const glm::dvec3 &direction,
                                std::size_t budget = 20'000);

/// A box that holds the whole fractal, each side reached as reachAlong() tells. Empty (all zero) for a mesh without
/// faces.
[[nodiscard]] Box extent(const FractalGraph &graph, const Mesh &base, std::size_t budget = 20'000);

}
