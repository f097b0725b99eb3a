// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>

namespace romanesco {

/// Bytes [begin, end) of one text.
struct SourceRange {
    std::size_t begin = 0;
    std::size_t end = 0;

    [[nodiscard]] std::size_t length() const { return end - begin; }
    /// Whether a cursor at offset touches it: it stands inside, or just before or after.
    [[nodiscard]] bool touches(std::size_t offset) const { return begin <= offset && offset <= end; }
    bool operator==(const SourceRange &) const = default;
};

/// From the begin of the first to the end of the last.
[[nodiscard]] inline SourceRange joined(SourceRange first, SourceRange last)
{
    return {first.begin, last.end};
}

/// Bytes [begin, end) of one line, counted from its start: what was read of a line stays true wherever it moves.
struct LineRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    [[nodiscard]] std::size_t length() const { return end - begin; }
    /// In the text whose line starts at an offset.
    [[nodiscard]] SourceRange from(std::size_t lineStart) const { return {lineStart + begin, lineStart + end}; }
    bool operator==(const LineRange &) const = default;
};

/// A range of a line that starts at offset 0. (Texts are below 2 GB.)
[[nodiscard]] inline LineRange inLine(SourceRange range)
{
    return {static_cast<std::uint32_t>(range.begin), static_cast<std::uint32_t>(range.end)};
}

}
