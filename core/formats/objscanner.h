// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/text/diagnostic.h"
#include "leadingdigits.h"
#include "numbers.h"

namespace romanesco {

/// An error where bytes are no text at all: compressed, or UTF-16.
[[nodiscard]] std::optional<Diagnostic> refusalOfBytes(std::string_view bytes);

/// Goes once through the bytes of a Wavefront text (OBJ or MTL). Words stand between blanks; a backslash at the end of a
/// line is a blank too, so that the line goes on in the next. A line ends at LF, CR LF or a CR alone, or with the text.
/// What it gives are views of the text, which must outlive it.
class ObjScanner
{
public:
    /// A BOM is passed over.
    explicit ObjScanner(std::string_view text)
        : m_begin(text.data())
        , m_at(text.data() + (text.starts_with("\xEF\xBB\xBF") ? 3 : 0))
        , m_end(text.data() + text.size())
    {
    }

    [[nodiscard]] bool isAtEnd() const { return m_at == m_end; }
    [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(m_at - m_begin); }
    void goTo(std::size_t offset) { m_at = m_begin + offset; }
    [[nodiscard]] bool isAt(char character) const { return m_at < m_end && *m_at == character; }
    /// Whether a word has ended here: at a blank or the end of the line.
    [[nodiscard]] bool isAtWordEnd() const { return isWordEnd(m_at); }

    /// Passes over the blanks; whether a word stands behind them on this line that starts no comment.
    bool toWord()
    {
        while (isBlank(charAt(m_at)) || isContinuation(m_at)) {
            passBlank();
        }
        return !isLineEnd(charAt(m_at)) && *m_at != '#';
    }

    /// Takes what stands here up to where the word ends.
    std::string_view takeWord()
    {
        const char *begin = m_at;
        while (!isWordEnd(m_at)) {
            ++m_at;
        }
        return {begin, m_at};
    }

    /// Takes a character if it is the next.
    bool take(char character)
    {
        const bool isNext = isAt(character);
        m_at += isNext ? 1 : 0;
        return isNext;
    }

    /// Takes digits; false where there are none. What does not fit 64 bits gives the greatest value.
    bool takeWhole(std::uint64_t &value)
    {
        const LeadingDigits digits = leadingDigits(m_at, m_end);
        value = digits.value;
        m_at += digits.count;
        if (digits.count == 8) [[unlikely]] {
            value = takeLongWhole();
        }
        return digits.count > 0;
    }

    /// Takes the word that stands here as numberFromText() reads it.
    ParsedNumber takeNumber()
    {
        const bool isNegative = isAt('-');
        const char *at = m_at + (isNegative || isAt('+') ? 1 : 0);
        const LeadingDigits whole = leadingDigits(at, m_end);
        at += whole.count;
        LeadingDigits decimals;
        if (charAt(at) == '.') {
            decimals = leadingDigits(at + 1, m_end);
            at += 1 + decimals.count;
        }
        const int count = whole.count + decimals.count;
        if (count == 0 || count > 15 || !isWordEnd(at)) {
            return numberFromText(takeWord());
        }
        // Clinger 1990: both are exact, so that the division's is the only rounding.
        const std::uint64_t power = powers[static_cast<std::size_t>(decimals.count)];
        const double value = static_cast<double>(whole.value * power + decimals.value) / static_cast<double>(power);
        m_at = at;
        return {isNegative ? -value : value, NumberStatus::Good};
    }

    /// Takes all that is left of the line without the blanks around it, comments too: names may hold blanks and "#".
    /// Of a line that goes on it is a copy, good until the next call.
    std::string_view takeRest();
    /// Passes over the rest of the line and its end.
    void skipLine()
    {
        if (!isLineEnd(charAt(m_at))) {
            m_at = lineEnd();
        }
        passLineEnd();
    }

private:
    static constexpr std::uint64_t powers[] = {1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000};

    [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
    [[nodiscard]] static bool isLineEnd(char c) { return c == '\n' || c == '\r'; }
    /// The end of the text looks like that of a line.
    [[nodiscard]] char charAt(const char *at) const { return at < m_end ? *at : '\n'; }
    [[nodiscard]] bool isContinuation(const char *at) const
    {
        return charAt(at) == '\\' && m_end - at > 1 && isLineEnd(at[1]);
    }
    [[nodiscard]] bool isWordEnd(const char *at) const
    {
        return isBlank(charAt(at)) || isLineEnd(charAt(at)) || isContinuation(at);
    }
    void passBlank()
    {
        if (*m_at++ == '\\') {
            passLineEnd();
        }
    }
    void passLineEnd()
    {
        take('\r');
        take('\n');
    }
    std::uint64_t takeLongWhole();
    const char *lineEnd();

    const char *m_begin;
    const char *m_at;
    const char *m_end;
    /// The first LF behind m_at or the end, if it is not before: texts of CRs alone are not searched again and again.
    const char *m_feed = nullptr;
    std::string m_joined;
};

}
