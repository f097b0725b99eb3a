// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoplace.h"

#include <algorithm>

#include "core/text/lexer.h"

namespace romanesco {

namespace {

using Kind = FdoPlace::Kind;

/// Reads what stands before the cursor as a parser would, up to where the cursor's own word is asked for. Each function
/// returns false once there is nothing left to read: the place is found, or the grammar is left.
class PlaceFinder
{
public:
    PlaceFinder(std::string_view line, std::size_t skipped)
        : m_line(line)
        , m_lexer(line.substr(std::min(skipped, line.size())), skipped)
    {
        if (skipped <= line.size()) {
            readLine();
        }
    }

    [[nodiscard]] FdoPlace take() { return std::move(m_place); }

private:
    /// Whether the cursor stands where the next word is asked for, after at most the start of one.
    bool isHere(Kind kind, LexMode mode = LexMode::Value)
    {
        const Token next = m_lexer.peek(mode);
        const bool isWord = next.is(TokenKind::Name) || next.is(TokenKind::Number) || next.is(TokenKind::Index);
        const bool isBegun = isWord && next.range.end == m_line.size();
        if (!isBegun && !next.is(TokenKind::EndOfLine)) {
            return false;
        }
        m_place.kind = kind;
        m_place.begun = inLine({isBegun ? next.range.begin : m_line.size(), m_line.size()});
        return true;
    }

    bool takes(TokenKind kind)
    {
        const bool isNext = m_lexer.peek().is(kind);
        if (isNext) {
            m_lexer.take();
        }
        return isNext;
    }

    void readLine()
    {
        if (isHere(Kind::LineStart)) {
            return;
        }
        const Token first = m_lexer.take();
        if (first.is(TokenKind::Less)) {
            readResult(first.range.begin);
        } else if (first.is(TokenKind::Name) && takes(TokenKind::Dot)) {
            readTransformationOrValue();
        } else if (first.is(TokenKind::Name) && takes(TokenKind::Less)) {
            readRecursive();
        }
    }

    // object := "<$>" "." value
    void readResult(std::size_t begin)
    {
        if (std::string_view("<$>").starts_with(m_line.substr(begin))) {
            m_place.kind = Kind::LineStart;
            m_place.begun = inLine({begin, m_line.size()});
        } else if (takes(TokenKind::Dollar) && takes(TokenKind::Greater) && takes(TokenKind::Dot)) {
            readValue();
        }
    }

    // recursive := NAME "<" NAME ">" "." value
    void readRecursive()
    {
        if (isHere(Kind::BaseName)) {
            return;
        }
        const Token base = m_lexer.take();
        if (base.is(TokenKind::Name) && takes(TokenKind::Greater) && takes(TokenKind::Dot)) {
            m_place.base = base.text;
            readValue();
        }
    }

    void readTransformationOrValue()
    {
        if (isHere(Kind::Value)) {
            return;
        }
        LineLexer ahead = m_lexer;
        const Token first = ahead.take();
        const Token second = ahead.peek();
        const bool isTransformation = first.is(TokenKind::OpenParenthesis)
            || (first.is(TokenKind::Name) && (second.is(TokenKind::Dot) || second.is(TokenKind::OpenParenthesis)));
        if (isTransformation) {
            readTransformation();
        } else {
            readValue();
        }
    }

    // transformation := NAME "." (NAME ".")*0..3 "(" out "," out "," out ")"
    void readTransformation()
    {
        while (m_lexer.peek().is(TokenKind::Name)) {
            m_place.parameters.push_back(m_lexer.take().text);
            if (!takes(TokenKind::Dot)) {
                return;
            }
        }
        if (!takes(TokenKind::OpenParenthesis)) {
            return;
        }
        for (int i = 0; i < 3; ++i) {
            if (isHere(Kind::Part)) {
                return;
            }
            m_lexer.take();
            if (!takes(TokenKind::Comma)) {
                return;
            }
        }
    }

    // value := STRING(.obj) | "[" use ("," use)* "]" value | NAME | NAME INDEX
    void readValue()
    {
        while (!isHere(Kind::Value)) {
            const Token next = m_lexer.take();
            if (next.is(TokenKind::UnclosedString)) {
                m_place.kind = Kind::MeshPath;
                m_place.begun = inLine({next.range.begin + 1, next.range.end});
            }
            if (!next.is(TokenKind::OpenBracket) || !readSet()) {
                return;
            }
        }
    }

    bool readSet()
    {
        do {
            if (isHere(Kind::UseName)) {
                return false;
            }
            const Token use = m_lexer.take();
            if (!use.is(TokenKind::Hash) && !(use.is(TokenKind::Name) && readArguments(use))) {
                return false;
            }
        } while (takes(TokenKind::Comma));
        return takes(TokenKind::CloseBracket);
    }

    // use := "#" | NAME ("." arg)*0..3 ["."]
    bool readArguments(const Token &use)
    {
        for (std::size_t count = 0; m_lexer.peek(LexMode::Index).is(TokenKind::Dot); ++count) {
            m_lexer.take(LexMode::Index);
            if (isHere(Kind::Argument, LexMode::Index)) {
                m_place.transformation = use.text;
                m_place.argument = count;
                return false;
            }
            const Token argument = m_lexer.peek(LexMode::Index);
            if (!argument.is(TokenKind::Index) && !argument.is(TokenKind::Name)) {
                break; // the trailing dot
            }
            m_lexer.take(LexMode::Index);
        }
        return true;
    }

    std::string_view m_line;
    LineLexer m_lexer;
    FdoPlace m_place;
};

}

FdoPlace fdoPlace(std::string_view line, std::size_t skipped)
{
    return PlaceFinder(line, skipped).take();
}

}
