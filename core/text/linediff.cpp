// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "linediff.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <ranges>
#include <span>
#include <unordered_map>
#include <utility>

namespace romanesco {

namespace {

constexpr std::size_t mostDifferences = 2'000;

using Lines = std::vector<std::string_view>;
using Numbers = std::vector<std::uint32_t>;

/// Equal lines get equal numbers.
std::pair<Numbers, Numbers> numbered(const Lines &before, const Lines &after)
{
    std::unordered_map<std::string_view, std::uint32_t> known;
    const auto numbersOf = [&](const Lines &lines) {
        Numbers numbers;
        numbers.reserve(lines.size());
        for (const std::string_view line : lines) {
            numbers.push_back(known.try_emplace(line, static_cast<std::uint32_t>(known.size())).first->second);
        }
        return numbers;
    };
    Numbers first = numbersOf(before);
    return {std::move(first), numbersOf(after)};
}

/// The furthest way to each diagonal k = x - y by d differences, for each d up to the one that reaches the end.
class Ways
{
public:
    Ways(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b)
        : m_a(a)
        , m_b(b)
    {
    }

    /// Whether few differences are enough.
    bool search()
    {
        const auto size = static_cast<std::int32_t>(mostDifferences);
        for (std::int32_t d = 0; d <= size; ++d) {
            std::vector<std::int32_t> &row = m_rows.emplace_back(2 * static_cast<std::size_t>(d) + 1);
            for (std::int32_t k = -d; k <= d; k += 2) {
                std::int32_t x = d == 0 ? 0 : comesFromAbove(d, k) ? at(d - 1, k + 1) : at(d - 1, k - 1) + 1;
                while (x < width() && x - k < height() && m_a[index(x)] == m_b[index(x - k)]) {
                    ++x;
                }
                row[index(k + d)] = x;
                if (x >= width() && x - k >= height()) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Back from the end; after a search that found it.
    [[nodiscard]] std::vector<LineChange> changes(std::size_t offset) const
    {
        std::vector<LineChange> changes; // from the last
        std::int32_t x = width();
        std::int32_t y = height();
        for (auto d = static_cast<std::int32_t>(m_rows.size()) - 1; d > 0; --d) {
            const std::int32_t k = x - y;
            const bool isInserted = comesFromAbove(d, k);
            const std::int32_t from = isInserted ? k + 1 : k - 1;
            x = at(d - 1, from);
            y = x - from;
            const std::size_t line = offset + index(x);
            const std::size_t otherLine = offset + index(y);
            const LineChange change{line, line + !isInserted, otherLine, otherLine + isInserted};
            const bool touches = !changes.empty() && changes.back().oldBegin == change.oldEnd
                && changes.back().newBegin == change.newEnd;
            if (touches) {
                changes.back().oldBegin = change.oldBegin;
                changes.back().newBegin = change.newBegin;
            } else {
                changes.push_back(change);
            }
        }
        std::ranges::reverse(changes);
        return changes;
    }

private:
    static std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] std::int32_t width() const { return static_cast<std::int32_t>(m_a.size()); }
    [[nodiscard]] std::int32_t height() const { return static_cast<std::int32_t>(m_b.size()); }
    [[nodiscard]] std::int32_t at(std::int32_t d, std::int32_t k) const { return m_rows[index(d)][index(k + d)]; }
    /// The last difference of the furthest way is a line of b; else it is one of a.
    [[nodiscard]] bool comesFromAbove(std::int32_t d, std::int32_t k) const
    {
        return k == -d || (k != d && at(d - 1, k - 1) < at(d - 1, k + 1));
    }

    std::span<const std::uint32_t> m_a;
    std::span<const std::uint32_t> m_b;
    std::vector<std::vector<std::int32_t>> m_rows;
};

bool isInsideCharacter(std::string_view text, std::size_t at)
{
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80;
}

/// Where each line begins; one more, for what would follow the last.
std::vector<std::size_t> startsOf(const Lines &lines)
{
    std::vector<std::size_t> starts{0};
    starts.reserve(lines.size() + 1);
    for (const std::string_view line : lines) {
        starts.push_back(starts.back() + line.size() + 1);
    }
    return starts;
}

/// Only what differs.
TextEdit trimmed(std::string_view before, SourceRange old, std::string_view text)
{
    const std::string_view was = before.substr(old.begin, old.length());
    std::size_t start = commonStart(was, text);
    while (start > 0 && (isInsideCharacter(was, start) || isInsideCharacter(text, start))) {
        --start;
    }
    std::size_t end = commonEnd(was.substr(start), text.substr(start));
    while (end > 0 && (isInsideCharacter(was, was.size() - end) || isInsideCharacter(text, text.size() - end))) {
        --end;
    }
    return {{old.begin + start, old.end - end}, std::string(text.substr(start, text.size() - start - end))};
}

}

std::vector<std::string_view> linesOf(std::string_view text)
{
    Lines lines;
    for (const auto line : std::views::split(text, '\n')) {
        lines.emplace_back(line.begin(), line.end());
    }
    if (lines.empty()) {
        lines.emplace_back(); // split() has nothing for an empty text
    }
    return lines;
}

std::vector<LineChange> lineChanges(const Lines &before, const Lines &after)
{
    const auto [a, b] = numbered(before, after);
    const std::size_t most = std::min(a.size(), b.size());
    std::size_t start = 0;
    while (start < most && a[start] == b[start]) {
        ++start;
    }
    std::size_t end = 0;
    while (end < most - start && a[a.size() - end - 1] == b[b.size() - end - 1]) {
        ++end;
    }
    const std::span<const std::uint32_t> middleOfA(a.data() + start, a.size() - start - end);
    const std::span<const std::uint32_t> middleOfB(b.data() + start, b.size() - start - end);
    Ways ways(middleOfA, middleOfB);
    if (ways.search()) {
        return ways.changes(start);
    }
    return {{start, a.size() - end, start, b.size() - end}};
}

TextEdits editsBetween(std::string_view before, std::string_view after)
{
    const Lines oldLines = linesOf(before);
    const Lines newLines = linesOf(after);
    const std::vector<std::size_t> oldStarts = startsOf(oldLines);
    const std::vector<std::size_t> newStarts = startsOf(newLines);
    TextEdits edits;
    for (const LineChange &change : lineChanges(oldLines, newLines)) {
        SourceRange old{oldStarts[change.oldBegin], oldStarts[change.oldEnd]};
        SourceRange now{newStarts[change.newBegin], newStarts[change.newEnd]};
        // The last line has no end: there the end of the line before comes or goes.
        if (change.oldEnd == oldLines.size()) {
            assert(change.newEnd == newLines.size() && (old.begin > 0) == (now.begin > 0)
                   && "changes of the same texts");
            const std::size_t back = old.begin > 0 ? 1 : 0;
            old = {old.begin - back, old.end - 1};
            now = {now.begin - back, now.end - 1};
        }
        edits.push_back(trimmed(before, old, after.substr(now.begin, now.length())));
    }
    return edits;
}

}
