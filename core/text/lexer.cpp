// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "lexer.h"

#include <algorithm>

#include "unicode.h"

namespace romanesco {

std::size_t nameLength(std::string_view text)
{
    std::size_t length = 0;
    while (length < text.size()) {
        const CodePoint point = firstCodePoint(text.substr(length));
        if (!point.isValid || !isNamePart(point.value)) {
            break;
        }
        length += point.length;
    }
    return length;
}

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

std::size_t skipBlanks(std::string_view line, std::size_t at)
{
    return std::min(line.find_first_not_of(blanks, at), line.size());
}

/// A number ends at a blank, `,`, `)`, `]`, `#` or the end of the line. The opening ones, quotes, `<`, `>` and `$` end
/// it as well, so that one slip does not swallow the rest.
std::size_t numberLength(std::string_view text)
{
    const std::size_t end = text.find_first_of(" \t\v\f,)]#([\"<>$");
    return end == text.npos ? text.size() : end;
}

bool startsNumber(std::string_view text)
{
    if (text[0] == '+' || text[0] == '-') {
        text.remove_prefix(1);
    }
    if (!text.empty() && text[0] == '.') {
        text.remove_prefix(1);
    }
    return !text.empty() && isDigit(text[0]);
}

TokenKind punctuation(char c)
{
    switch (c) {
    case '.':
        return TokenKind::Dot;
    case ',':
        return TokenKind::Comma;
    case '(':
        return TokenKind::OpenParenthesis;
    case ')':
        return TokenKind::CloseParenthesis;
    case '[':
        return TokenKind::OpenBracket;
    case ']':
        return TokenKind::CloseBracket;
    case '<':
        return TokenKind::Less;
    case '>':
        return TokenKind::Greater;
    case '$':
        return TokenKind::Dollar;
    case '#':
        return TokenKind::Hash;
    default:
        return TokenKind::Unknown;
    }
}

struct Extent {
    TokenKind kind;
    std::size_t length;
};

Extent scan(std::string_view text, LexMode mode)
{
    if (text.empty()) {
        return {TokenKind::EndOfLine, 0};
    }
    if (text[0] == '"') {
        const std::size_t quote = text.find('"', 1);
        return quote == text.npos ? Extent{TokenKind::UnclosedString, text.size()}
                                  : Extent{TokenKind::String, quote + 1};
    }
    if (mode == LexMode::Index && isDigit(text[0])) {
        std::size_t length = 1;
        while (length < text.size() && isDigit(text[length])) {
            ++length;
        }
        // `1a` is one wrong word, not an index and a name.
        const std::size_t word = nameLength(text);
        return word > length ? Extent{TokenKind::Number, word} : Extent{TokenKind::Index, length};
    }
    if (mode == LexMode::Value && startsNumber(text)) {
        return {TokenKind::Number, numberLength(text)};
    }
    const CodePoint point = firstCodePoint(text);
    if (point.isValid && isNameStart(point.value)) {
        return {TokenKind::Name, nameLength(text)};
    }
    return {point.length == 1 && point.isValid ? punctuation(text[0]) : TokenKind::Unknown, point.length};
}

}

std::string described(const Token &token)
{
    switch (token.kind) {
    case TokenKind::EndOfLine:
        return "the end of the line";
    case TokenKind::Hash:
        return "a comment";
    case TokenKind::Unknown:
        if (static_cast<unsigned char>(token.text[0]) < 0x20) {
            return "a control character";
        }
        [[fallthrough]];
    default:
        return '"' + std::string(token.text) + '"';
    }
}

LineLexer::LineLexer(std::string_view line, std::size_t offset)
    : m_line(line)
    , m_offset(offset)
{
}

Token LineLexer::peek(LexMode mode) const
{
    const std::size_t at = skipBlanks(m_line, m_at);
    const auto [kind, length] = scan(m_line.substr(at), mode);
    return {kind, {m_offset + at, m_offset + at + length}, m_line.substr(at, length)};
}

Token LineLexer::take(LexMode mode)
{
    const Token token = peek(mode);
    m_at = token.range.end - m_offset;
    return token;
}

bool LineLexer::isBlankBeforeNext() const
{
    return m_at == 0 || skipBlanks(m_line, m_at) > m_at;
}

}
