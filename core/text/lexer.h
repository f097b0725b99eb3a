// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>

#include "sourcerange.h"

namespace romanesco {

enum class TokenKind {
    EndOfLine,
    Name,
    Number,         ///< a sign, digits, a decimal point, an exponent; also what only looks like one ("1e", "0x1")
    Index,          ///< digits alone, read in LexMode::Index
    String,         ///< with its quotes
    UnclosedString, ///< from the quote to the end of the line
    Dot,
    Comma,
    OpenParenthesis,
    CloseParenthesis,
    OpenBracket,
    CloseBracket,
    Less,
    Greater,
    Dollar,
    Hash,
    Unknown, ///< any other code point, or an ill-formed byte
};

struct Token {
    TokenKind kind = TokenKind::EndOfLine;
    SourceRange range;
    std::string_view text;

    [[nodiscard]] bool is(TokenKind other) const { return kind == other; }
};

/// What a message calls a token that was found: its text in quotes, or "the end of the line". A Hash is called a comment,
/// which it is wherever it is not taken.
[[nodiscard]] std::string described(const Token &token);

/// What separates words in a line.
constexpr std::string_view blanks = " \t\v\f";

/// How many bytes at the start can be the rest of a name: letters, digits and `_`.
[[nodiscard]] std::size_t nameLength(std::string_view text);

/// After NAME and a dot, digits are an index and never a decimal: `t.1.2` is t with 1 and 2.
enum class LexMode { Value, Index };

/// Cuts one line into tokens, on demand, since the grammar decides how digits are read. A `#` is a Hash wherever it
/// stands; whether it is the identity or starts a comment is the parser's to say. Never fails and always moves on.
class LineLexer
{
public:
    /// offset is where the line starts in the whole text; ranges count from there.
    LineLexer(std::string_view line, std::size_t offset);

    /// The next token, not consumed.
    [[nodiscard]] Token peek(LexMode mode = LexMode::Value) const;
    Token take(LexMode mode = LexMode::Value);

    /// Whether a blank (or the start of the line) stands before the next token.
    [[nodiscard]] bool isBlankBeforeNext() const;

private:
    std::string_view m_line;
    std::size_t m_offset;
    std::size_t m_at = 0;
};

}
