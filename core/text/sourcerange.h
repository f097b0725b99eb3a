// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

namespace romanesco {

/// Bytes [begin, end) of one text.
struct SourceRange {
    std::size_t begin = 0;
    std::size_t end = 0;

    [[nodiscard]] std::size_t length() const { return end - begin; }
    bool operator==(const SourceRange &) const = default;
};

/// From the begin of the first to the end of the last.
[[nodiscard]] inline SourceRange joined(SourceRange first, SourceRange last)
{
    return {first.begin, last.end};
}

}
