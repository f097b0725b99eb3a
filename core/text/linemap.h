// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sourcerange.h"

namespace romanesco {

/// A place in a text as people count: line and column from 1, columns in code points.
struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;
    bool operator==(const TextPosition &) const = default;
};

/// The lines of a text. A line ends at LF, CR LF or a CR alone; what follows the last end is a line too, if only an
/// empty one. Keeps a view of the text, which must outlive it. Building is one pass; a look-up is a binary search.
class LineMap
{
public:
    explicit LineMap(std::string_view text);

    [[nodiscard]] std::size_t lineCount() const { return m_starts.size(); }

    /// The bytes of a line (from 0), its end mark left out.
    [[nodiscard]] SourceRange line(std::size_t index) const;

    [[nodiscard]] TextPosition position(std::size_t offset) const;

private:
    std::string_view m_text;
    std::vector<std::size_t> m_starts;
};

}
