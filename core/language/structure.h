// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/text/linemap.h"
#include "fdodocument.h"

namespace romanesco {

/// One entry of an outline.
struct OutlineEntry {
    std::string name;
    SymbolKind kind = SymbolKind::Unknown;
    /// The name where it is declared.
    SourceRange range;
    /// The line from 0.
    std::size_t line = 0;
};

/// Everything that is declared by a name of its own, and the result `<$>`, in the order of the text. Plain `v` is left
/// out: vectors() counts those.
[[nodiscard]] std::vector<OutlineEntry> outline(const FdoDocument &document);

/// Lines [first, last], from 0, of which all but the first can be folded away.
struct FoldingRange {
    std::size_t first = 0;
    std::size_t last = 0;
    bool operator==(const FoldingRange &) const = default;
};

/// The sections of a text of either language: each starts with a comment of whole lines, at the start of the text or
/// after a blank line, and ends before the next, blank lines at its end left out.
[[nodiscard]] std::vector<FoldingRange> foldingRanges(const LineMap &lines);

/// What an editor writes behind a vector, since the language counts them: `v 1 1 -2  ·6`.
struct Inlay {
    /// Where the declaration ends, before blanks and a comment.
    std::size_t offset = 0;
    /// The vector's number, from 1.
    std::uint32_t number = 0;
};

/// Of the vectors in lines [first, end), as an editor shows them.
[[nodiscard]] std::vector<Inlay> inlays(const FdoDocument &document, std::size_t first, std::size_t end);

/// A number that a slider for depth moves: of `z 6` the 6.
struct DepthNumber {
    std::string name;
    std::uint64_t value = 0;
    SourceRange range;
};

/// Every `NAME INDEX` of the text, in its order.
[[nodiscard]] std::vector<DepthNumber> depthNumbers(const FdoDocument &document);

/// The edit that gives <$> another depth: the number that it meets first from <$> inwards. Empty where there is none.
[[nodiscard]] TextEdits withDepth(const FdoDocument &document, std::uint64_t depth);

}
