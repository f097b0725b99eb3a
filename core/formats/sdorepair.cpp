// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sdorepair.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "numbers.h"

namespace romanesco {

namespace {

/// Reads on from where something starts, and notes what would have to be put in for it to be right.
class Repair
{
public:
    explicit Repair(LineLexer ahead)
        : m_ahead(ahead)
        , m_end(m_ahead.peek().range.begin)
    {
    }

    bool readVector()
    {
        if (takeOrInsert(TokenKind::Hash, nullptr)) {
            return true;
        }
        openBefore(m_ahead.peek());
        for (int i = 0; i < 3; ++i) {
            if (i > 0) {
                takeOrInsert(TokenKind::Comma, ",");
            }
            if (!takeOrInsert(TokenKind::Number, nullptr)) {
                return false;
            }
        }
        takeOrInsert(TokenKind::CloseParenthesis, ")");
        return true;
    }

    bool readTransform()
    {
        if (isOver()) {
            return false;
        }
        LineLexer inside = m_ahead;
        const bool isOpen = inside.take().is(TokenKind::OpenParenthesis);
        if (isOpen && !inside.peek().is(TokenKind::Number)) {
            take();
        } else {
            insert(m_end, "(");
        }
        for (int i = 0; i < 3; ++i) {
            if (i > 0 && isOver()) {
                insert(m_end, ", #");
                continue;
            }
            if (i > 0) {
                takeOrInsert(TokenKind::Comma, ",");
            }
            if (isOver()) {
                insert(m_end, i > 0 ? " #" : "#");
            } else if (!readVector()) {
                return false;
            }
        }
        takeOrInsert(TokenKind::CloseParenthesis, ")");
        return true;
    }

    std::optional<Fix> fix()
    {
        if (m_edits.empty() || isLeftOpen()) {
            return std::nullopt;
        }
        return Fix{title(), std::move(m_edits)};
    }

private:
    void take() { m_end = m_ahead.take().range.end; }

    /// Whether it was there. Nothing is put in where text is null.
    bool takeOrInsert(TokenKind kind, const char *text)
    {
        const bool isThere = m_ahead.peek().is(kind);
        if (isThere) {
            take();
        } else if (text) {
            insert(m_end, text);
        }
        return isThere;
    }

    void openBefore(const Token &token)
    {
        if (token.is(TokenKind::OpenParenthesis)) {
            take();
        } else {
            insert(token.range.begin, "(");
        }
    }

    void insert(std::size_t at, std::string_view text)
    {
        if (m_edits.empty() || m_edits.back().range.begin != at) {
            m_edits.push_back({{at, at}, {}});
        }
        m_edits.back().text += text;
    }

    /// Nothing more follows but a closing bracket or a comment: a `#` before what cannot follow an identity.
    [[nodiscard]] bool isOver() const
    {
        LineLexer ahead = m_ahead;
        const Token token = ahead.take();
        const Token next = ahead.peek();
        const bool isComment = token.is(TokenKind::Hash) && !next.is(TokenKind::Comma)
            && !next.is(TokenKind::CloseParenthesis) && !next.is(TokenKind::Hash) && !next.is(TokenKind::EndOfLine);
        return isComment || token.is(TokenKind::EndOfLine) || token.is(TokenKind::CloseParenthesis);
    }

    /// Whether the guess was wrong: a bracket that follows closes what was taken to be closed, or a comma goes on.
    [[nodiscard]] bool isLeftOpen() const
    {
        LineLexer ahead = m_ahead;
        Token token = ahead.take();
        while (!token.is(TokenKind::EndOfLine) && !token.is(TokenKind::Hash) && !token.is(TokenKind::OpenParenthesis)) {
            if (token.is(TokenKind::CloseParenthesis) || token.is(TokenKind::Comma)) {
                return true;
            }
            token = ahead.take();
        }
        return false;
    }

    [[nodiscard]] std::string title() const
    {
        const std::string &text = m_edits.front().text;
        const bool isOne =
            text.size() == 1 && std::ranges::all_of(m_edits, [&](const TextEdit &edit) { return edit.text == text; });
        if (!isOne) {
            return "Insert what is missing";
        }
        const std::string what = text == "," ? "comma" : text;
        return "Insert the missing " + (m_edits.size() > 1 && text == "," ? "commas" : what);
    }

    LineLexer m_ahead;
    std::size_t m_end;
    TextEdits m_edits;
};

/// The numbers of a vector, and what stands between them.
struct Numbers {
    enum class Gap { Blank, TightComma, Comma };
    std::vector<Token> tokens;
    std::vector<Gap> gaps;
};

Numbers numbersOf(LineLexer &ahead)
{
    Numbers numbers;
    while (ahead.peek().is(TokenKind::Number)) {
        numbers.tokens.push_back(ahead.take());
        const Token token = ahead.peek();
        auto gap = Numbers::Gap::Blank;
        if (token.is(TokenKind::Comma)) {
            ahead.take();
            const bool isTight = token.range.begin == numbers.tokens.back().range.end && !ahead.isBlankBeforeNext();
            gap = isTight ? Numbers::Gap::TightComma : Numbers::Gap::Comma;
        }
        numbers.gaps.push_back(gap);
    }
    if (!numbers.gaps.empty()) {
        numbers.gaps.pop_back();
    }
    return numbers;
}

/// Takes every tight comma for a decimal one. Nothing where there is none, or where a number would not be one.
std::optional<DecimalCommas> withPoints(const Numbers &numbers)
{
    DecimalCommas result;
    result.fix.title = "Write decimal points";
    for (std::size_t i = 0; i < numbers.gaps.size(); ++i) {
        const Token &left = numbers.tokens[i];
        const Token &right = numbers.tokens[i + 1];
        if (numbers.gaps[i] == Numbers::Gap::Blank) {
            result.fix.edits.push_back({{left.range.end, left.range.end}, ","});
        }
        if (numbers.gaps[i] != Numbers::Gap::TightComma) {
            continue;
        }
        const std::string joint = std::string(left.text) + '.' + std::string(right.text);
        const bool isChain = i > 0 && numbers.gaps[i - 1] == Numbers::Gap::TightComma;
        if (isChain || numberFromText(joint).status == NumberStatus::Malformed) {
            return std::nullopt;
        }
        if (result.number.empty()) {
            result.number = joint;
            result.range = joined(left.range, right.range);
        }
        result.fix.edits.push_back({{left.range.end, right.range.begin}, "."});
    }
    return result.number.empty() ? std::nullopt : std::optional(std::move(result));
}

}

std::optional<Fix> repairedVector(LineLexer ahead)
{
    Repair repair(ahead);
    return repair.readVector() ? repair.fix() : std::nullopt;
}

std::optional<Fix> repairedTransform(LineLexer ahead)
{
    Repair repair(ahead);
    return repair.readTransform() ? repair.fix() : std::nullopt;
}

std::optional<DecimalCommas> decimalCommasInVector(LineLexer ahead)
{
    if (ahead.peek().is(TokenKind::OpenParenthesis)) {
        ahead.take();
    }
    Numbers numbers = numbersOf(ahead);
    auto tight = std::ranges::count(numbers.gaps, Numbers::Gap::TightComma);
    if (tight == 5 && numbers.gaps.size() == 5) { // (1,5,2,5,3,5)
        numbers.gaps[1] = numbers.gaps[3] = Numbers::Gap::Comma;
        tight = 3;
    }
    const bool makesThree = std::ssize(numbers.tokens) - tight == 3;
    return makesThree ? withPoints(numbers) : std::nullopt;
}

std::optional<DecimalCommas> decimalCommaInNumber(LineLexer ahead)
{
    Numbers numbers = numbersOf(ahead);
    const bool isOne = !numbers.gaps.empty() && numbers.gaps.front() == Numbers::Gap::TightComma;
    if (!isOne) {
        return std::nullopt;
    }
    numbers.tokens.resize(2);
    numbers.gaps.erase(numbers.gaps.begin() + 1, numbers.gaps.end()); // resize() lets GCC 14 warn, wrongly
    return withPoints(numbers);
}

}
