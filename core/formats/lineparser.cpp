// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "lineparser.h"

#include <algorithm>
#include <format>

#include "numbers.h"
#include "parsedlines.h"

namespace romanesco {

std::optional<Diagnostic> foreignEncoding(std::string_view text)
{
    const auto problem = [](const char *words) { return Diagnostic{DiagnosticCode::NotUtf8, {0, 0}, {words}}; };
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        return problem("it looks like UTF-16");
    }
    if (text.substr(0, 4096).contains('\0')) {
        return problem("it holds NUL bytes");
    }
    return std::nullopt;
}

namespace {

/// Up to the last ending of a file's name; 0 where there is none.
std::size_t pathLength(std::string_view words)
{
    std::size_t length = 0;
    for (std::size_t dot = words.find('.'); dot != words.npos; dot = words.find('.', dot + 1)) {
        const std::string_view upTo = words.substr(0, dot + 4);
        if (hasEnding(upTo, ".obj") || hasEnding(upTo, ".fdo")) {
            length = upTo.size();
        }
    }
    return length;
}

}

LineParser::LineParser(std::string_view line, std::size_t skipped, Diagnostics &diagnostics)
    : m_line(line)
    , m_lexer(line.substr(skipped), skipped)
    , m_diagnostics(diagnostics)
    , m_lastEnd(skipped)
{
}

bool LineParser::error(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments,
                       std::optional<Fix> fix)
{
    m_diagnostics.push_back({code, range, std::move(arguments), std::move(fix)});
    return false;
}

bool LineParser::expected(std::string what, const Token &found, std::optional<Fix> fix)
{
    return error(DiagnosticCode::Expected, found.range, {described(found), std::move(what)}, std::move(fix));
}

Token LineParser::take(LexMode mode)
{
    const Token token = m_lexer.take(mode);
    m_lastEnd = token.range.end;
    return token;
}

bool LineParser::take(TokenKind kind, const char *what)
{
    const Token token = peek();
    if (token.is(kind)) {
        take();
        return true;
    }
    if (kind == TokenKind::CloseParenthesis && !token.is(TokenKind::Comma)) {
        return expected(what, token, insertion("Insert the missing )", m_lastEnd, ")"));
    }
    return expected(what, token);
}

bool LineParser::parseEnd()
{
    const Token token = peek();
    if (token.is(TokenKind::EndOfLine) || token.is(TokenKind::Hash)) {
        return true;
    }
    return error(DiagnosticCode::TrailingText, token.range, {described(token)},
                 insertion("Make it a comment", token.range.begin, m_lexer.isBlankBeforeNext() ? "# " : " # "));
}

bool LineParser::parseNumber(double &value, const char *what)
{
    const Token token = peek();
    if (!token.is(TokenKind::Number)) {
        return expected(what, token);
    }
    take();
    const auto [number, status] = numberFromText(token.text);
    value = number;
    const std::string written(token.text);
    switch (status) {
    case NumberStatus::Good:
        return true;
    case NumberStatus::Underflow:
        error(DiagnosticCode::NumberTooSmall, token.range, {written}, replacement("Write 0", token.range, "0"));
        return true;
    case NumberStatus::Overflow:
        return error(DiagnosticCode::NumberTooLarge, token.range, {written});
    case NumberStatus::Malformed:
        break;
    }
    return error(DiagnosticCode::BadNumber, token.range, {written});
}

std::optional<Fix> LineParser::quotes(std::size_t begin) const
{
    if (begin < m_line.size() && m_line[begin] == '\'') {
        const std::size_t other = m_line.find('\'', begin + 1);
        if (other == m_line.npos) {
            return std::nullopt;
        }
        return Fix{"Write double quotes", {{{begin, begin + 1}, "\""}, {{other, other + 1}, "\""}}};
    }
    const std::size_t length = pathLength(m_line.substr(begin));
    if (length == 0) {
        return std::nullopt;
    }
    const std::size_t end = begin + length;
    return Fix{"Put it in quotes", {{{begin, begin}, "\""}, {{end, end}, "\""}}};
}

bool LineParser::parseIndex(std::uint64_t &index)
{
    const Token token = take();
    const std::optional<std::uint64_t> value = wholeFromText(token.text);
    if (value) {
        index = *value;
        return true;
    }
    // `+6` and `6.0` are clear enough
    std::string_view digits = token.text;
    digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
    const std::size_t dot = std::min(digits.find('.'), digits.size());
    const bool isWhole = digits.substr(dot).find_first_not_of(".0") == digits.npos;
    digits = digits.substr(0, dot);
    std::optional<Fix> fix;
    if (isWhole && wholeFromText(digits)) {
        fix = replacement(std::format("Write {}", digits), token.range, std::string(digits));
    }
    return error(DiagnosticCode::BadIndex, token.range, {std::string(token.text)}, std::move(fix));
}

bool LineParser::parseString(SourceRange &quoted)
{
    const Token token = peek();
    if (token.is(TokenKind::UnclosedString)) {
        // after the name's ending, else at the end of the line
        const std::size_t length = pathLength(token.text);
        const std::size_t end = length > 0 ? length : token.text.find_last_not_of(blanks) + 1;
        return error(DiagnosticCode::UnclosedString, token.range, {},
                     insertion("Insert the missing quote", token.range.begin + end, "\""));
    }
    if (!token.is(TokenKind::String)) {
        return expected("a path in quotes", token, quotes(token.range.begin));
    }
    take();
    quoted = token.range;
    return true;
}

std::string_view unquoted(std::string_view string)
{
    string.remove_prefix(string.starts_with('"') ? 1 : 0);
    string.remove_suffix(string.ends_with('"') ? 1 : 0);
    return string;
}

bool hasEnding(std::string_view path, std::string_view ending)
{
    const auto isSame = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b; };
    return path.size() >= ending.size() && std::ranges::equal(path.substr(path.size() - ending.size()), ending, isSame);
}

}
