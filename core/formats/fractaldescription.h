// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/affinemap.h"
#include "core/text/sourcerange.h"
#include "levelsequence.h"

namespace romanesco {

/// The maps of one level, in the order of the text, each once; `#` is kept apart as holdsIdentity.
struct TransformSet {
    std::vector<AffineMap> maps;
    /// Where each map was written, beside maps.
    std::vector<SourceRange> uses;
    bool holdsIdentity = false;
    SourceRange range;

    [[nodiscard]] std::size_t size() const { return maps.size() + (holdsIdentity ? 1 : 0); }
};

/// What an .fdo text says: a base mesh and the levels round it. Ranges are of that text.
struct FractalDescription {
    std::string meshPath;
    SourceRange meshRange;
    std::vector<TransformSet> sets;
    LevelSequence levels;

    /// The number that a depth slider moves: from <$> inwards through assignments and sets, the first `NAME INDEX`.
    struct Depth {
        std::uint64_t value;
        SourceRange range;
    };
    std::optional<Depth> depth;
};

}
