// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "sourcerange.h"
#include "textposition.h"

namespace romanesco {

/// The lines of a text. A line ends at LF, CR LF or a CR alone; what follows the last end is a line too, if only an
/// empty one. Keeps a view of the text, which must outlive it. Building is one pass; a look-up is a binary search.
class LineMap
{
public:
    explicit LineMap(std::string_view text);

    [[nodiscard]] std::string_view text() const { return m_text; }
    [[nodiscard]] std::size_t lineCount() const { return m_starts.size(); }

    /// Where a line (from 0) starts; for lineCount(), the size of the text.
    [[nodiscard]] std::size_t start(std::size_t index) const
    {
        return index < m_starts.size() ? m_starts[index] : m_text.size();
    }
    /// The bytes of a line, its end mark left out.
    [[nodiscard]] SourceRange line(std::size_t index) const;
    [[nodiscard]] std::string_view lineText(std::size_t index) const;
    /// The line that holds an offset; its end mark is part of it. Beyond the text it is the last line.
    [[nodiscard]] std::size_t lineAt(std::size_t offset) const;

    [[nodiscard]] TextPosition position(std::size_t offset) const;
    /// The way back; what is beyond a line or the text is the end of it.
    [[nodiscard]] std::size_t offset(TextPosition position) const;

private:
    std::string_view m_text;
    std::vector<std::size_t> m_starts;
};

}
