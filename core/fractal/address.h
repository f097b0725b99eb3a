// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/formats/levelsequence.h"
#include "core/geometry/affinemap.h"

namespace romanesco {

class FractalGraph;

/// A map of the set at a level.
struct Pick {
    Position position = 0;
    std::uint32_t map = 0;
    bool operator==(const Pick &) const = default;
};

/// Names a copy: the picks that lead to it, outermost first. Levels that are passed over (their `#` is taken) are left
/// out, so that equal copies have equal addresses.
using Address = std::vector<Pick>;

/// Where the copy stands: the product of the picks' maps, outermost on the left. Every pick must be one of the graph's.
/// Cost: a product and a search of the level for each pick.
[[nodiscard]] AffineMap mapOf(const FractalGraph &graph, std::span<const Pick> address);

}
