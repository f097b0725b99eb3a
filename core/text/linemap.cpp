// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "linemap.h"

#include <algorithm>

#include "unicode.h"

namespace romanesco {

LineMap::LineMap(std::string_view text)
    : m_text(text)
    , m_starts{0}
{
    for (std::size_t at = text.find_first_of("\r\n"); at != text.npos; at = text.find_first_of("\r\n", at)) {
        const bool pair = text.substr(at, 2) == "\r\n";
        at += pair ? 2 : 1;
        m_starts.push_back(at);
    }
}

SourceRange LineMap::line(std::size_t index) const
{
    const std::size_t begin = m_starts[index];
    std::size_t end = index + 1 < m_starts.size() ? m_starts[index + 1] : m_text.size();
    while (end > begin && index + 1 < m_starts.size() && (m_text[end - 1] == '\n' || m_text[end - 1] == '\r')) {
        --end;
    }
    return {begin, end};
}

TextPosition LineMap::position(std::size_t offset) const
{
    offset = std::min(offset, m_text.size());
    const auto next = std::upper_bound(m_starts.begin(), m_starts.end(), offset);
    const std::size_t index = static_cast<std::size_t>(next - m_starts.begin()) - 1;
    const std::string_view before = m_text.substr(m_starts[index], offset - m_starts[index]);
    return {index + 1, codePointCount(before) + 1};
}

}
