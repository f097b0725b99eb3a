// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "completionlist.h"

#include <algorithm>

#include "core/formats/lineparser.h"
#include "core/text/unicode.h"

namespace romanesco {

namespace {

char lowered(char c)
{
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
}

bool beginsAlike(std::string_view label, std::string_view begun)
{
    return label.size() >= begun.size()
        && std::ranges::equal(label.substr(0, begun.size()), begun, {}, lowered, lowered);
}

/// Where the rest of a path ends: at its quote if the line has one.
std::size_t pathEnd(std::string_view text, std::size_t at)
{
    const std::size_t lineEnd = std::min(text.find_first_of("\r\n", at), text.size());
    const std::size_t quote = text.find('"', at);
    return quote < lineEnd ? quote : std::min(text.find_first_of(blanks, at), lineEnd);
}

}

CompletionList::CompletionList(std::string_view text, SourceRange begun, bool isInQuotes)
    : m_text(text)
    , m_begun(text.substr(begun.begin, begun.length()))
    , m_replaced(begun)
    , m_isInQuotes(isInQuotes)
{
    if (isInQuotes) {
        m_replaced.end = pathEnd(text, begun.end);
    } else if (begun.length() > 0) {
        m_replaced.end = begun.end + nameLength(text.substr(begun.end));
    }
}

bool CompletionList::wants(std::string_view label) const
{
    return !isFull() && beginsAlike(label, m_begun);
}

void CompletionList::add(std::string label, std::string detail, std::string_view words, CompletionKind kind)
{
    if (wants(label)) {
        m_list.push_back({std::move(label), std::move(detail), {m_replaced, std::string(words)}, kind});
    }
}

void CompletionList::add(std::string label, std::string detail, std::string_view words, std::string_view ending,
                         CompletionKind kind)
{
    const bool isThere = m_text.substr(m_replaced.end).starts_with(ending);
    add(std::move(label), std::move(detail), std::string(words) += isThere ? "" : ending, kind);
}

void CompletionList::addFiles(const FileNames &files, std::string_view ending)
{
    for (const std::string &path : files()) {
        const bool isPossible = hasEnding(path, ending) && path.find_first_of("\"\r\n") == path.npos;
        if (isPossible && wants(path)) {
            add(path, {}, m_isInQuotes ? path : '"' + path, "\"", CompletionKind::File);
        }
    }
}

std::string_view CompletionList::following() const
{
    const std::string_view rest = m_text.substr(m_replaced.end);
    return rest.substr(std::min(rest.find_first_not_of(blanks), rest.size()));
}

}
