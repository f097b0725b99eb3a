// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/diagnostic.h"
#include "core/text/lexer.h"

namespace romanesco {

/// What the parsers of a line of either language share. Each function reports at most one error and returns false after
/// it. Places count from the start of the line.
class LineParser
{
protected:
    /// The first bytes of the line, so many, are passed over. diagnostics must outlive it.
    LineParser(std::string_view line, std::size_t skipped, Diagnostics &diagnostics);

    /// Always false.
    bool error(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments = {},
               std::optional<Fix> fix = std::nullopt);
    bool expected(std::string what, const Token &found, std::optional<Fix> fix = std::nullopt);

    /// What is next must be of this kind. A closing bracket that is missing can be put in by a fix.
    bool take(TokenKind kind, const char *what);

    /// Nothing but a comment may follow a whole declaration.
    bool parseEnd();

    bool parseNumber(double &value, const char *what = "a number");
    /// A token that is known to be digits, or looks like a number. What does not fit 64 bits becomes the greatest value.
    bool parseIndex(std::uint64_t &index);
    /// A path in quotes; gives the range with them.
    bool parseString(SourceRange &quoted);

    /// The end of the token that was taken last.
    [[nodiscard]] std::size_t lastEnd() const { return m_lastEnd; }
    [[nodiscard]] const LineLexer &lexer() const { return m_lexer; }
    [[nodiscard]] Token peek(LexMode mode = LexMode::Value) const { return m_lexer.peek(mode); }
    Token take(LexMode mode = LexMode::Value);
    [[nodiscard]] std::string text(SourceRange range) const
    {
        return std::string(m_line.substr(range.begin, range.length()));
    }
    [[nodiscard]] std::string_view line() const { return m_line; }

private:
    /// Quotes round what looks like a path.
    [[nodiscard]] std::optional<Fix> quotes(std::size_t begin) const;

    std::string_view m_line;
    LineLexer m_lexer;
    Diagnostics &m_diagnostics;
    std::size_t m_lastEnd;
};

/// What stands between the quotes of a string; the last one may be missing.
[[nodiscard]] std::string_view unquoted(std::string_view string);

/// Whether a path ends so, whatever the case; the ending is in lower case (".obj").
[[nodiscard]] bool hasEnding(std::string_view path, std::string_view ending);

}
