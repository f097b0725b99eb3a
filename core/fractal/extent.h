// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "fractalgraph.h"

namespace romanesco {

/// A box that holds the whole fractal, each side within a few per cent of the least that does: for each of the six
/// directions a best-first search for the greatest reach, over the states' spheres, which ends with the answer or after
/// `budget` states with the largest bound that is left. Empty (all zero) for a mesh without faces.
[[nodiscard]] Box extent(const FractalGraph &graph, const Mesh &base, std::size_t budget = 4'000);

}
