// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "core/geometry/box.h"
#include "fractalgraph.h"

namespace romanesco {

/// A box round what the levels between two positions make of what lies in a box, by intervals: exact along each axis where
/// maps only move, scale or mirror along axes, also over 10^18 levels; loose where they turn. Never beyond the sphere of
/// the position. No repeat may go over the end. Cost: some looks at each map between the two.
[[nodiscard]] Box grownBox(const FractalGraph &graph, Position begin, Position end, const Box &box);

}
