// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "formatter.h"

#include <algorithm>
#include <map>
#include <optional>
#include <span>

#include "core/text/lexer.h"
#include "core/text/unicode.h"

namespace romanesco {

namespace {

/// Columns beyond it are an accident, and two lines must not move thousands far out.
constexpr std::size_t farthestColumn = 200;

/// What the layout of a good line depends on beside its tokens.
struct Manner {
    /// A vector of .fdo, whose first number may stand in a column.
    bool isVector = false;
    /// Dots stand between parameters, not before a value.
    bool hasParameters = false;
    /// Outside brackets a # that begins before this is the identity.
    std::size_t identitiesEnd = 0;
};

Manner mannerOf(const FdoLine &line)
{
    return {std::holds_alternative<VectorDeclaration>(line.declaration),
            std::holds_alternative<TransformationDeclaration>(line.declaration), 0};
}

Manner mannerOf(const SdoLine &line)
{
    return {.identitiesEnd = line.range.end};
}

/// Blanks between two tokens or round them all: how many there are to be, and where they are.
struct Gap {
    SourceRange range;
    std::size_t blankCount;
};

/// The gaps of one line of code. Those that are right already are left out, but for the two that columns may change.
struct Layout {
    std::vector<Gap> gaps;
    /// Into gaps: after a vector's name, and before a comment.
    std::optional<std::size_t> nameGap;
    std::optional<std::size_t> commentGap;
    /// In code points: of the vector's name, and of all before the comment.
    std::size_t nameWidth = 0;
    std::size_t codeWidth = 0;
};

/// Reads the tokens of one good line and says how far they stand apart.
class LineLayout
{
public:
    /// text is the line, which starts at an offset of the whole; its first bytes, so many, are passed over.
    LineLayout(std::string_view text, std::size_t offset, std::size_t skipped, Manner manner)
        : m_text(text)
        , m_offset(offset)
        , m_end(offset + skipped)
        , m_lexer(text.substr(skipped), offset + skipped)
        , m_manner(manner)
    {
    }

    Layout read()
    {
        std::optional<Token> dot; // shown once it is known to have something behind it
        Token token = take();
        for (; !token.is(TokenKind::EndOfLine) && !isComment(token); token = take()) {
            const bool isUseEnd = token.is(TokenKind::Comma) || token.is(TokenKind::CloseBracket);
            if (dot && !isUseEnd) {
                place(*dot);
            }
            dot.reset();
            if (token.is(TokenKind::Dot)) {
                dot = token;
            } else {
                place(token);
            }
        }
        if (token.is(TokenKind::Hash)) {
            m_layout.commentGap = m_layout.gaps.size();
            m_layout.gaps.push_back({{m_end, token.range.begin}, 1});
            m_end = m_offset + m_text.find_last_not_of(blanks) + 1;
        }
        add({m_end, m_offset + m_text.size()}, 0);
        return std::move(m_layout);
    }

private:
    /// In a set digits after a dot are an index.
    Token take()
    {
        const Token token = m_lexer.take(m_brackets > 0 ? LexMode::Index : LexMode::Value);
        m_brackets += token.is(TokenKind::OpenBracket) ? 1 : token.is(TokenKind::CloseBracket) ? -1 : 0;
        m_parentheses += token.is(TokenKind::OpenParenthesis) ? 1 : token.is(TokenKind::CloseParenthesis) ? -1 : 0;
        return token;
    }

    [[nodiscard]] bool isComment(const Token &token) const
    {
        return token.is(TokenKind::Hash) && m_brackets == 0 && m_parentheses == 0
            && token.range.begin >= m_offset + m_manner.identitiesEnd;
    }

    void add(SourceRange range, std::size_t blankCount)
    {
        const std::string_view now = m_text.substr(range.begin - m_offset, range.length());
        if (now.size() != blankCount || now.find_first_not_of(' ') != now.npos) {
            m_layout.gaps.push_back({range, blankCount});
        }
    }

    void place(const Token &token)
    {
        const std::size_t blankCount = m_previous && isApart(*m_previous, token.kind) ? 1 : 0;
        const SourceRange gap{m_end, token.range.begin};
        if (m_manner.isVector && m_layout.nameWidth > 0 && !m_layout.nameGap) {
            m_layout.nameGap = m_layout.gaps.size();
            m_layout.gaps.push_back({gap, blankCount});
        } else {
            add(gap, blankCount);
        }
        const std::size_t width = codePointCount(token.text);
        m_layout.nameWidth = m_previous ? m_layout.nameWidth : width;
        m_layout.codeWidth += blankCount + width;
        m_previous = token.kind;
        m_end = token.range.end;
    }

    /// Whether a blank stands between two tokens: `t.a. (a, #, 5)`, `z<x>. [#, u.6.10] y`, `o "x.obj" # # note`.
    [[nodiscard]] bool isApart(TokenKind left, TokenKind right) const
    {
        switch (right) {
        case TokenKind::Dot:
        case TokenKind::Comma:
        case TokenKind::CloseParenthesis:
        case TokenKind::CloseBracket:
        case TokenKind::Less:
        case TokenKind::Greater:
            return false;
        default:
            break;
        }
        switch (left) {
        case TokenKind::OpenParenthesis:
        case TokenKind::OpenBracket:
        case TokenKind::Less:
        case TokenKind::Dollar:
            return false;
        case TokenKind::Dot: // not before a parameter or an argument
            return right != TokenKind::Index
                && (right != TokenKind::Name || (m_brackets == 0 && !m_manner.hasParameters));
        default:
            return true;
        }
    }

    std::string_view m_text;
    std::size_t m_offset;
    /// Where the token placed last ends.
    std::size_t m_end;
    LineLexer m_lexer;
    Manner m_manner;
    int m_brackets = 0;
    int m_parentheses = 0;
    std::optional<TokenKind> m_previous;
    Layout m_layout;
};

/// A gap that may end at a column, and the width of what stands before it.
struct Cell {
    Gap *gap;
    std::size_t width;
};

/// Widens gaps of adjacent lines to the least column at which two of them end already, behind different widths: that
/// was meant. Where a line's own width goes beyond it, its gap stays one blank.
void alignToColumn(std::string_view text, std::span<const Cell> cells)
{
    const auto column = [text](const Cell &cell) {
        const SourceRange range = cell.gap->range;
        const bool isPlain = text.substr(range.begin, range.length()).find_first_not_of(' ') == text.npos;
        return cell.width + (isPlain ? std::max(range.length(), std::size_t{1}) : 1);
    };
    std::map<std::size_t, std::size_t> widths; // of the first that ends at a column
    std::optional<std::size_t> shared;
    for (const Cell &cell : cells) {
        const std::size_t at = column(cell);
        const bool isMeant = widths.try_emplace(at, cell.width).first->second != cell.width;
        if (isMeant && at <= farthestColumn && (!shared || at < *shared)) {
            shared = at;
        }
    }
    for (const Cell &cell : cells) {
        cell.gap->blankCount = shared && cell.width < *shared ? *shared - cell.width : 1;
    }
}

/// Goes through a text line by line. Good lines of code wait until their run ends, since columns need all of it.
template<typename Syntax>
class Formatter
{
public:
    explicit Formatter(const Syntax &syntax)
        : m_syntax(syntax)
        , m_text(syntax.text())
        , m_map(syntax.map())
        , m_mark(syntax.skipped(0))
    {
    }

    TextEdits read()
    {
        for (std::size_t i = 0; i < m_syntax.lineCount(); ++i) {
            const SourceRange line = contentOf(i);
            const std::size_t first = m_text.find_first_not_of(blanks, line.begin);
            if (first >= line.end) {
                continue;
            }
            if (i > m_next) {
                endRun();
                closeUp(m_next, i);
            }
            readLine(i, line, first);
            m_next = i + 1;
        }
        endRun();
        if (m_syntax.lineCount() > 0) {
            endText();
        }
        return std::move(m_edits);
    }

private:
    /// A line without its end and without a byte order mark.
    [[nodiscard]] SourceRange contentOf(std::size_t line) const
    {
        const SourceRange range = m_map.line(line);
        return {range.begin + m_syntax.skipped(line), range.end};
    }

    void readLine(std::size_t index, SourceRange line, std::size_t first)
    {
        const auto &parsed = m_syntax.line(index);
        const std::size_t end = m_text.find_last_not_of(blanks, line.end - 1) + 1;
        if (!parsed.isBad && m_text[first] != '#') {
            const std::size_t start = m_map.start(index);
            const Manner manner = mannerOf(parsed);
            m_run.push_back(LineLayout(m_map.lineText(index), start, line.begin - start, manner).read());
            return;
        }
        endRun();
        if (!parsed.isBad) {
            replace({line.begin, first}, "");
        }
        replace({end, line.end}, "");
    }

    void endRun()
    {
        std::vector<Cell> names;
        for (Layout &layout : m_run) {
            if (layout.nameGap) {
                names.push_back({&layout.gaps[*layout.nameGap], layout.nameWidth});
            } else {
                alignToColumn(m_text, names);
                names.clear();
            }
        }
        alignToColumn(m_text, names);

        std::vector<Cell> comments;
        for (Layout &layout : m_run) {
            if (layout.commentGap) {
                const std::size_t widened = layout.nameGap ? layout.gaps[*layout.nameGap].blankCount - 1 : 0;
                comments.push_back({&layout.gaps[*layout.commentGap], layout.codeWidth + widened});
            }
        }
        alignToColumn(m_text, comments);

        for (const Layout &layout : m_run) {
            for (const Gap &gap : layout.gaps) {
                replace(gap.range, std::string(gap.blankCount, ' '));
            }
        }
        m_run.clear();
    }

    /// Of the blank lines [begin, end) before a line that is not, the first stays; at the start of the text none.
    void closeUp(std::size_t begin, std::size_t end)
    {
        // what says something about the encoding at the start only must not come to stand there
        const std::string_view rest = m_text.substr(m_map.start(end));
        const bool wouldMark = m_mark == 0 && (rest.starts_with(byteOrderMark) || foreignEncoding(rest));
        if (begin == 0 && !wouldMark) {
            replace({m_mark, m_map.start(end)}, "");
            return;
        }
        const SourceRange line = m_map.line(begin);
        const std::size_t next = m_map.start(begin + 1);
        // a CR before and an LF behind would become one line end
        const bool wouldJoin =
            begin > 0 && line.length() > 0 && m_text[line.begin - 1] == '\r' && m_text[line.end] == '\n';
        if (wouldJoin) {
            replace({line.begin, next}, "\r");
        } else {
            replace(line, "");
        }
        replace({next, m_map.start(end)}, "");
    }

    void endText()
    {
        if (m_next == 0) {
            replace({m_mark, m_text.size()}, "");
        } else if (m_next < m_map.lineCount()) {
            replace({m_map.start(m_next), m_text.size()}, "");
        } else {
            replace({m_text.size(), m_text.size()}, usualLineEnd());
        }
    }

    [[nodiscard]] std::string_view usualLineEnd() const
    {
        std::map<std::string_view, std::size_t> counts{{"\n", 0}, {"\r", 0}, {"\r\n", 0}};
        for (std::size_t i = 0; i + 1 < m_map.lineCount(); ++i) {
            const std::size_t end = m_map.line(i).end;
            ++counts[m_text.substr(end, m_map.start(i + 1) - end)];
        }
        return std::ranges::max_element(counts, {}, [](const auto &entry) { return entry.second; })->first;
    }

    void replace(SourceRange range, std::string_view words)
    {
        if (m_text.substr(range.begin, range.length()) != words) {
            m_edits.push_back({range, std::string(words)});
        }
    }

    const Syntax &m_syntax;
    std::string_view m_text;
    const LineMap &m_map;
    /// The length of the byte order mark.
    std::size_t m_mark;
    /// The line after the last one that is not blank.
    std::size_t m_next = 0;
    std::vector<Layout> m_run;
    TextEdits m_edits;
};

template<typename Syntax>
TextEdits editsFor(const Syntax &syntax)
{
    // a NUL that moves nearer to the start would make the text none
    return syntax.text().contains('\0') ? TextEdits() : Formatter(syntax).read();
}

}

TextEdits formatting(const FdoSyntax &syntax)
{
    return editsFor(syntax);
}

TextEdits formatting(const SdoSyntax &syntax)
{
    return editsFor(syntax);
}

}
