// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>

#include "completionlist.h"
#include "core/text/lexer.h"

namespace romanesco {

namespace {

/// What a cursor's place in a line of .sdo asks for.
struct SdoPlace {
    enum class Kind { Nothing, LineStart, Identity, Projection, Path } kind = Kind::Nothing;
    LineRange begun;
    bool isInQuotes = false;
    /// Of a path.
    std::string_view ending = {};
};

using Kind = SdoPlace::Kind;

/// Reads what stands before the cursor, up to where the cursor's own word is asked for. Each function returns false once
/// there is nothing left to read: the place is found, or the grammar is left.
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

    [[nodiscard]] SdoPlace place() const { return m_place; }

private:
    /// Two words do not touch, so that nothing is offered right behind one.
    bool isHere(Kind kind)
    {
        const Token next = m_lexer.peek();
        const bool isBegun = next.is(TokenKind::Name) && next.range.end == m_line.size();
        if (!isBegun && !next.is(TokenKind::EndOfLine)) {
            return false;
        }
        m_place.kind = isBegun || m_lexer.isBlankBeforeNext() || m_isAfterBracket ? kind : Kind::Nothing;
        m_place.begun = inLine({isBegun ? next.range.begin : m_line.size(), m_line.size()});
        return true;
    }

    bool takes(TokenKind kind)
    {
        const bool isNext = m_lexer.peek().is(kind);
        if (isNext) {
            m_lexer.take();
            m_isAfterBracket = kind == TokenKind::OpenParenthesis || kind == TokenKind::Comma;
        }
        return isNext;
    }

    void readLine()
    {
        if (isHere(Kind::LineStart)) {
            return;
        }
        const std::string_view letter = m_lexer.take().text;
        if (letter == "c") {
            (void)(readVector() && readVector() && takes(TokenKind::Number) && isHere(Kind::Projection));
        } else if (letter == "o" || letter == "p") {
            (void)(readPath(".obj") && readTransform()); // for p numbers follow
        } else if (letter == "f") {
            (void)(readPath(".fdo") && readTransform());
        } else if (letter == "l") {
            (void)(readVector() && readVector());
        }
    }

    bool readPath(std::string_view ending)
    {
        m_place.ending = ending;
        if (isHere(Kind::Path)) {
            return false;
        }
        const Token path = m_lexer.take();
        if (path.is(TokenKind::UnclosedString)) {
            m_place.kind = Kind::Path;
            m_place.isInQuotes = true;
            m_place.begun = inLine({path.range.begin + 1, path.range.end});
        }
        return path.is(TokenKind::String);
    }

    // transform := "(" vec "," vec "," vec ")" | "#"
    bool readTransform()
    {
        if (isHere(Kind::Identity)) {
            return false;
        }
        if (takes(TokenKind::Hash)) {
            return true;
        }
        return takes(TokenKind::OpenParenthesis) && readVector() && takes(TokenKind::Comma) && readVector()
            && takes(TokenKind::Comma) && readVector() && takes(TokenKind::CloseParenthesis);
    }

    // vec := "(" number "," number "," number ")" | "#"
    bool readVector()
    {
        if (isHere(Kind::Identity)) {
            return false;
        }
        if (takes(TokenKind::Hash)) {
            return true;
        }
        return takes(TokenKind::OpenParenthesis) && takes(TokenKind::Number) && takes(TokenKind::Comma)
            && takes(TokenKind::Number) && takes(TokenKind::Comma) && takes(TokenKind::Number)
            && takes(TokenKind::CloseParenthesis);
    }

    std::string_view m_line;
    LineLexer m_lexer;
    SdoPlace m_place;
    bool m_isAfterBracket = false;
};

bool hasOtherCamera(const SdoSyntax &syntax, std::size_t line)
{
    for (std::size_t i = 0; i < syntax.lineCount(); ++i) {
        if (i != line && std::holds_alternative<CameraLine>(syntax.line(i).declaration)) {
            return true;
        }
    }
    return false;
}

void addLetters(CompletionList &list, bool hasCamera)
{
    struct Letter {
        const char *letter;
        const char *detail;
    };
    for (const auto &[letter, detail] :
         {Letter{"c", "the camera"}, {"o", "an object"}, {"f", "a fractal"}, {"p", "a ball"}, {"l", "a light"}}) {
        if (!hasCamera || letter[0] != 'c') {
            list.add(letter, detail, letter, " ", CompletionKind::Keyword);
        }
    }
}

}

std::vector<Completion> complete(const SdoSyntax &syntax, std::size_t offset, const FileNames &files)
{
    const LineMap &map = syntax.map();
    const std::size_t line = map.lineAt(offset);
    if (line >= syntax.lineCount() || offset > map.line(line).end) {
        return {};
    }
    const std::string_view text = map.lineText(line).substr(0, offset - map.start(line));
    const SdoPlace place = PlaceFinder(text, syntax.skipped(line)).place();
    CompletionList list(syntax.text(), syntax.range(line, place.begun), place.isInQuotes);
    switch (place.kind) {
    case Kind::Nothing:
        break;
    case Kind::LineStart:
        addLetters(list, hasOtherCamera(syntax, line));
        break;
    case Kind::Identity:
        list.add("#", "the identity", "#", CompletionKind::Identity);
        break;
    case Kind::Projection:
        list.add("perspective", "the view is an angle in degrees", "perspective", CompletionKind::Keyword);
        list.add("orthographic", "the view is a height", "orthographic", CompletionKind::Keyword);
        break;
    case Kind::Path:
        list.addFiles(files, place.ending);
        break;
    }
    return list.take();
}

}
