// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text/diagnostic.h"
#include "core/text/linemap.h"
#include "core/text/textedit.h"
#include "core/text/unicode.h"

namespace romanesco {

/// What the first bytes say about an encoding that is not UTF-8; nothing where they say nothing.
[[nodiscard]] std::optional<Diagnostic> foreignEncoding(std::string_view text);

/// A text and its lines, each read by itself: Line is what a parser made of it, with `Diagnostics diagnostics`, all
/// places counted from the start of the line. When the text changes, only the lines that differ are read anew, so that a
/// keystroke in a text of any length costs a comparison of the two texts and the reading of one line.
template<typename Line>
class ParsedLines
{
public:
    [[nodiscard]] const std::string &text() const { return *m_text; }
    [[nodiscard]] const LineMap &map() const { return m_map; }

    /// No line is read of a text that is not UTF-8.
    [[nodiscard]] std::size_t lineCount() const { return m_lines.size(); }
    [[nodiscard]] const Line &line(std::size_t index) const { return m_lines[index]; }
    /// The bytes at the start of a line that are not part of it: a byte order mark.
    [[nodiscard]] std::size_t skipped(std::size_t line) const { return skipped(line, *m_text); }
    [[nodiscard]] SourceRange range(std::size_t line, LineRange range) const { return range.from(m_map.start(line)); }
    [[nodiscard]] std::string_view words(std::size_t line, LineRange range) const
    {
        return std::string_view(*m_text).substr(m_map.start(line) + range.begin, range.length());
    }

    /// What was found in reading, in the order of the text.
    [[nodiscard]] Diagnostics diagnostics() const
    {
        Diagnostics all;
        if (m_encodingProblem) {
            all.push_back(*m_encodingProblem);
        }
        for (std::size_t i = 0; i < m_lines.size(); ++i) {
            for (const Diagnostic &diagnostic : m_lines[i].diagnostics) {
                shift(all.emplace_back(diagnostic), m_map.start(i));
            }
        }
        return all;
    }

protected:
    /// parse(line, skipped) reads a line, whose first bytes (a byte order mark) are to be passed over.
    template<typename Parse>
    void setText(std::string text, Parse &&parse)
    {
        auto next = std::make_unique<const std::string>(std::move(text));
        LineMap map(*next);
        m_encodingProblem = foreignEncoding(*next);
        if (m_encodingProblem) {
            m_lines.clear();
        } else {
            readLines(*next, map, parse);
        }
        m_text = std::move(next);
        m_map = std::move(map);
    }

private:
    [[nodiscard]] static std::size_t skipped(std::size_t line, std::string_view text)
    {
        return line == 0 && text.starts_with(byteOrderMark) ? byteOrderMark.size() : 0;
    }

    template<typename Parse>
    void readLines(std::string_view text, const LineMap &map, Parse &parse)
    {
        // Lines wholly within what both texts start with, or end with, are kept. The first byte of the line after
        // belongs to that: a CR may have become a CR LF.
        std::size_t keptFirst = 0;
        std::size_t keptLast = 0;
        if (!m_lines.empty()) {
            const std::string_view old = *m_text;
            const std::size_t alike = commonStart(old, text);
            keptFirst = alike > 0 ? m_map.lineAt(alike - 1) : 0;
            const std::size_t begin = m_map.start(keptFirst);
            const std::size_t alikeEnd = commonEnd(old.substr(begin), text.substr(begin));
            keptLast = alikeEnd > 0 ? m_lines.size() - 1 - m_map.lineAt(old.size() - alikeEnd) : 0;
        }
        std::vector<Line> fresh;
        for (std::size_t i = keptFirst; i + keptLast < map.lineCount(); ++i) {
            fresh.push_back(parse(map.lineText(i), skipped(i, text)));
        }
        splice(keptFirst, m_lines.size() - keptLast, std::move(fresh));
    }

    /// Puts lines in the place of [begin, end).
    void splice(std::size_t begin, std::size_t end, std::vector<Line> fresh)
    {
        if (m_lines.empty()) {
            m_lines = std::move(fresh);
            return;
        }
        const std::size_t common = std::min(fresh.size(), end - begin);
        const auto at = m_lines.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto middle = fresh.begin() + static_cast<std::ptrdiff_t>(common);
        std::move(fresh.begin(), middle, at);
        const auto rest = at + static_cast<std::ptrdiff_t>(common);
        m_lines.erase(rest, m_lines.begin() + static_cast<std::ptrdiff_t>(end));
        m_lines.insert(m_lines.begin() + static_cast<std::ptrdiff_t>(begin + common), std::make_move_iterator(middle),
                       std::make_move_iterator(fresh.end()));
    }

    std::unique_ptr<const std::string> m_text = std::make_unique<const std::string>();
    LineMap m_map{*m_text};
    std::optional<Diagnostic> m_encodingProblem;
    std::vector<Line> m_lines;
};

}
