// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "linemap.h"

#include <algorithm>

#include "unicode.h"

namespace romanesco {

namespace {

/// Where the character stands next, from an offset on; the end of the text where it does not. memchr looks at many
/// bytes at once, which a search for several characters does not.
std::size_t next(std::string_view text, char character, std::size_t from)
{
    const std::size_t at = text.find(character, from);
    return at == text.npos ? text.size() : at;
}

}

LineMap::LineMap(std::string_view text)
    : m_text(text)
    , m_starts{0}
{
    std::size_t feed = next(text, '\n', 0);
    std::size_t carriage = next(text, '\r', 0);
    while (feed < text.size() || carriage < text.size()) {
        std::size_t after = std::min(feed, carriage) + 1;
        if (carriage + 1 == feed && feed < text.size()) {
            after = feed + 1;
        }
        m_starts.push_back(after);
        if (feed < after) {
            feed = next(text, '\n', after);
        }
        if (carriage < after) {
            carriage = next(text, '\r', after);
        }
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

std::string_view LineMap::lineText(std::size_t index) const
{
    const SourceRange range = line(index);
    return m_text.substr(range.begin, range.length());
}

std::size_t LineMap::lineAt(std::size_t offset) const
{
    const auto next = std::upper_bound(m_starts.begin(), m_starts.end(), std::min(offset, m_text.size()));
    return static_cast<std::size_t>(next - m_starts.begin()) - 1;
}

TextPosition LineMap::position(std::size_t offset) const
{
    offset = std::min(offset, m_text.size());
    const std::size_t index = lineAt(offset);
    const std::string_view before = m_text.substr(m_starts[index], offset - m_starts[index]);
    return {index + 1, codePointCount(before) + 1};
}

std::size_t LineMap::offset(TextPosition position) const
{
    if (position.line > m_starts.size()) {
        return m_text.size();
    }
    const SourceRange range = line(position.line - 1);
    std::size_t at = range.begin;
    for (std::size_t column = 1; column < position.column && at < range.end; ++column) {
        at += firstCodePoint(m_text.substr(at, range.end - at)).length;
    }
    return at;
}

}
