// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/count.h"
#include "fdodocument.h"

namespace romanesco {

/// What the levels of an object amount to, or those of one iteration of a recursive.
struct LevelFacts {
    /// More are not listed.
    static constexpr std::size_t mostSizes = 16;

    Position levelCount = 0;
    /// The sizes of the first levels, outermost first: their different maps, `#` counted.
    std::vector<std::uint64_t> sizes;
    /// All sizes multiplied.
    Count instances = 1;
    /// Where the levels are one iteration of so many transformations, repeated, and nothing else.
    struct Iteration {
        Count transforms;
        std::uint64_t depth;
    };
    std::optional<Iteration> iteration;
};

/// Of a node of the document's forest, down to its mesh; of a recursive one iteration, down to its base. Nothing where it
/// is bad, or has more levels than can be counted, or where its sets hold too many transformations to be computed while
/// somebody waits (20,000). Cost linear in the nodes passed and those transformations, whatever the depth.
[[nodiscard]] std::optional<LevelFacts> levelFacts(const FdoDocument &document, std::uint32_t node);

}
