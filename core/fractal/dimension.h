// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "fractalgraph.h"

namespace romanesco {

/// The similarity dimension of an iteration as its depth grows: the D at which the scales of all that one pass makes, to
/// the power of D, add up to 1 (Moran 1946), each distinct word of the pass counted once. The dimension of the limit
/// where its copies hardly overlap; else above it, and above 3 at times. Six copies of a third: ln 6 / ln 3.
///
/// Nothing unless one iteration makes up the whole fractal and each of its maps is a similarity that contracts; nor
/// where some sets hold `#`, others not, and different ones share a map; nor for passes of more than 100,000 levels.
/// Cost: a logarithm and some powers for each map, some products for each level of the pass.
[[nodiscard]] std::optional<double> similarityDimension(const FractalGraph &graph);

}
