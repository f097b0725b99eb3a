// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objscanner.h"

#include <cstring>

namespace romanesco {

namespace {

/// Where the character stands first in [begin, end), else end. memchr looks at many bytes at once.
const char *find(const char *begin, const char *end, char character)
{
    const void *found = begin == end ? nullptr : std::memchr(begin, character, static_cast<std::size_t>(end - begin));
    return found ? static_cast<const char *>(found) : end;
}

std::string_view trimmed(std::string_view words)
{
    const std::size_t begin = words.find_first_not_of(" \t\v\f");
    if (begin == words.npos) {
        return {};
    }
    return words.substr(begin, words.find_last_not_of(" \t\v\f") + 1 - begin);
}

}

std::optional<Diagnostic> refusalOfBytes(std::string_view bytes)
{
    if (bytes.starts_with("\x1F\x8B")) {
        return Diagnostic{DiagnosticCode::ObjCompressed, {0, 0}, {}};
    }
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
        return Diagnostic{DiagnosticCode::NotUtf8, {0, 0}, {"it looks like UTF-16"}};
    }
    return std::nullopt;
}

const char *ObjScanner::lineEnd()
{
    if (m_feed == nullptr || m_feed < m_at) {
        m_feed = find(m_at, m_end, '\n');
    }
    return find(m_at, m_feed, '\r');
}

/// Eight digits have been taken.
std::uint64_t ObjScanner::takeLongWhole()
{
    const char *begin = m_at - 8;
    while (charAt(m_at) >= '0' && charAt(m_at) <= '9') {
        ++m_at;
    }
    return wholeFromText({begin, m_at}).value();
}

std::string_view ObjScanner::takeRest()
{
    const char *begin = m_at;
    m_at = lineEnd();
    std::string_view rest(begin, m_at);
    if (!rest.ends_with('\\') || m_at == m_end) {
        return trimmed(rest);
    }
    m_joined.clear();
    while (rest.ends_with('\\') && m_at != m_end) {
        m_joined += rest.substr(0, rest.size() - 1);
        m_joined += ' ';
        passLineEnd();
        begin = m_at;
        m_at = lineEnd();
        rest = {begin, m_at};
    }
    m_joined += rest;
    return trimmed(m_joined);
}

}
