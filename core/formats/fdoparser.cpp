// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoparser.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

#include "core/text/lexer.h"
#include "core/text/linemap.h"
#include "numbers.h"

namespace romanesco {

namespace {

constexpr std::size_t maximumParameters = 3;

/// Parses one line. Each parse function reports at most one error and returns false after it.
class LineParser
{
public:
    LineParser(std::string_view line, std::size_t offset, FdoSyntax &syntax)
        : m_lexer(line, offset)
        , m_syntax(syntax)
    {
    }

    // line := [ vector | transformation | object | recursive ] [comment]
    void parse()
    {
        const Token first = m_lexer.peek();
        switch (first.kind) {
        case TokenKind::EndOfLine:
        case TokenKind::Hash:
            return;
        case TokenKind::Less:
            parseResult();
            return;
        case TokenKind::Number:
            parseMisnamed();
            return;
        case TokenKind::Name:
            m_lexer.take();
            parseNamed({first.text, first.range});
            return;
        default:
            error(DiagnosticCode::ExpectedDeclaration, first.range, {described(first)});
        }
    }

private:
    bool error(DiagnosticCode code, SourceRange range, std::vector<std::string> arguments = {})
    {
        m_syntax.diagnostics.push_back({code, range, std::move(arguments)});
        return false;
    }

    bool expected(std::string what, const Token &found)
    {
        return error(DiagnosticCode::Expected, found.range, {described(found), std::move(what)});
    }

    bool take(TokenKind kind, const char *what)
    {
        const Token token = m_lexer.peek();
        if (!token.is(kind)) {
            return expected(what, token);
        }
        m_lexer.take();
        return true;
    }

    template<typename Node>
    void add(Node node, bool isGood)
    {
        m_syntax.declarations.push_back({std::move(node), !isGood});
    }

    /// Nothing but a comment may follow a whole declaration.
    bool parseEnd()
    {
        const Token token = m_lexer.peek();
        if (token.is(TokenKind::EndOfLine) || token.is(TokenKind::Hash)) {
            return true;
        }
        return error(DiagnosticCode::TrailingText, token.range, {described(token)});
    }

    void parseNamed(const Word &name)
    {
        const Token next = m_lexer.peek();
        if (next.is(TokenKind::Number) && !m_lexer.isBlankBeforeNext()) {
            add(VectorDeclaration{name},
                error(DiagnosticCode::BlankAfterVectorName, {name.range.end, next.range.end},
                      {std::string(name.text)}));
        } else if (next.is(TokenKind::Number) || (name.text == "v" && !next.is(TokenKind::Dot))) {
            VectorDeclaration vector{name};
            const bool isGood = parseVector(vector);
            add(std::move(vector), isGood);
        } else if (next.is(TokenKind::Dot)) {
            m_lexer.take();
            parseTransformationOrObject(name);
        } else if (next.is(TokenKind::Less)) {
            ObjectDeclaration object{name};
            const bool isGood = parseRecursive(object);
            add(std::move(object), isGood);
        } else if (looksLikeNumbers()) {
            add(VectorDeclaration{name}, expected("a number", next));
        } else {
            add(UnknownDeclaration{name}, error(DiagnosticCode::ExpectedAfterName, next.range, {described(next)}));
        }
    }

    /// Whether two of the words left are numbers, as in `half nan 0 0`: meant as a vector, which keeps its number.
    bool looksLikeNumbers() const
    {
        LineLexer ahead = m_lexer;
        int numbers = 0;
        for (Token token = ahead.take(); !token.is(TokenKind::EndOfLine) && !token.is(TokenKind::Hash);
             token = ahead.take()) {
            const bool isPossible = token.is(TokenKind::Number) || token.is(TokenKind::Name)
                || token.is(TokenKind::Comma) || token.is(TokenKind::Unknown) || token.is(TokenKind::OpenParenthesis)
                || token.is(TokenKind::CloseParenthesis);
            if (!isPossible) {
                return false;
            }
            numbers += token.is(TokenKind::Number) ? 1 : 0;
        }
        return numbers >= 2;
    }

    /// A line that starts with a number. If more follow, it was meant as a vector and keeps its number.
    void parseMisnamed()
    {
        const Token word = m_lexer.take();
        if (word.text[0] >= '0' && word.text[0] <= '9') {
            const std::string_view name = word.text.substr(0, word.text.find('.'));
            error(DiagnosticCode::NameStartsWithDigit, {word.range.begin, word.range.begin + name.size()},
                  {std::string(name)});
        } else {
            error(DiagnosticCode::ExpectedDeclaration, word.range, {described(word)});
        }
        if (m_lexer.peek().is(TokenKind::Number)) {
            add(VectorDeclaration{{{}, word.range}}, false);
        }
    }

    // vector := NAME number number number | NAME number "," number "," number
    bool parseVector(VectorDeclaration &vector)
    {
        bool hasComma[2] = {};
        SourceRange tight;
        SourceRange previous;
        for (int i = 0; i < 3; ++i) {
            if (i > 0) {
                const Token comma = m_lexer.peek();
                hasComma[i - 1] = comma.is(TokenKind::Comma);
                if (hasComma[i - 1]) {
                    m_lexer.take();
                    if (comma.range.begin == previous.end && !m_lexer.isBlankBeforeNext()) {
                        tight = {previous.begin, m_lexer.peek().range.end};
                    }
                }
                if (i == 2 && hasComma[0] != hasComma[1]) {
                    return parseMixedCommas(tight, joined(vector.name.range, m_lexer.peek().range));
                }
            }
            previous = m_lexer.peek().range;
            if (!parseNumber(vector.value[i])) {
                return false;
            }
        }
        return parseEnd();
    }

    /// `1,5 2`: a comma with no blanks round it is taken for a decimal comma.
    bool parseMixedCommas(SourceRange tight, SourceRange all)
    {
        if (tight.length() == 0) {
            return error(DiagnosticCode::MixedCommas, all);
        }
        std::string number(m_syntax.text.substr(tight.begin, tight.length()));
        std::ranges::replace(number, ',', '.');
        return error(DiagnosticCode::DecimalComma, tight, {number});
    }

    bool parseNumber(double &value)
    {
        const Token token = m_lexer.peek();
        if (!token.is(TokenKind::Number)) {
            return expected("a number", token);
        }
        m_lexer.take();
        const auto [number, status] = numberFromText(token.text);
        value = number;
        switch (status) {
        case NumberStatus::Good:
            return true;
        case NumberStatus::Underflow:
            error(DiagnosticCode::NumberTooSmall, token.range, {std::string(token.text)});
            return true;
        case NumberStatus::Overflow:
            return error(DiagnosticCode::NumberTooLarge, token.range, {std::string(token.text)});
        case NumberStatus::Malformed:
            break;
        }
        return error(DiagnosticCode::BadNumber, token.range, {std::string(token.text)});
    }

    // transformation := NAME "." (NAME ".")*0..3 "(" out "," out "," out ")"
    // object         := NAME "." value
    void parseTransformationOrObject(const Word &name)
    {
        LineLexer ahead = m_lexer;
        const Token first = ahead.take();
        const Token second = ahead.peek();
        const bool isTransformation = first.is(TokenKind::OpenParenthesis)
            || (first.is(TokenKind::Name) && (second.is(TokenKind::Dot) || second.is(TokenKind::OpenParenthesis)));
        if (isTransformation) {
            TransformationDeclaration transformation{name, {}, {}};
            const bool isGood = parseTransformation(transformation);
            add(std::move(transformation), isGood);
        } else {
            ObjectDeclaration object{name};
            const bool isGood = parseValue(object.value);
            add(std::move(object), isGood);
        }
    }

    bool parseTransformation(TransformationDeclaration &transformation)
    {
        while (m_lexer.peek().is(TokenKind::Name)) {
            const Token parameter = m_lexer.take();
            if (transformation.parameters.size() == maximumParameters) {
                return error(DiagnosticCode::TooManyParameters, parameter.range);
            }
            transformation.parameters.push_back({parameter.text, parameter.range});
            if (!take(TokenKind::Dot, "a dot")) {
                return false;
            }
        }
        if (!take(TokenKind::OpenParenthesis, "a parameter or \"(\"")) {
            return false;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            if (!parseResultVector(transformation.results[i])) {
                return false;
            }
            if (!(i < 2 ? take(TokenKind::Comma, "\",\"") : take(TokenKind::CloseParenthesis, "\")\""))) {
                return false;
            }
        }
        return parseEnd();
    }

    // out := parameter NAME | vector INDEX | vector NAME | "#"
    bool parseResultVector(std::optional<VectorReference> &result)
    {
        const Token token = m_lexer.peek();
        switch (token.kind) {
        case TokenKind::Hash:
            m_lexer.take();
            return true;
        case TokenKind::Name:
            m_lexer.take();
            result = VectorReference{{token.text, token.range}, std::nullopt};
            return true;
        case TokenKind::Number: {
            std::uint64_t index = 0;
            if (!parseIndex(index)) {
                return false;
            }
            result = VectorReference{{token.text, token.range}, index};
            return true;
        }
        default:
            return expected("a parameter, a vector or #", token);
        }
    }

    /// Digits alone. What does not fit 64 bits becomes the greatest value, which names no vector.
    bool parseIndex(std::uint64_t &index)
    {
        const Token token = m_lexer.take();
        const std::optional<std::uint64_t> value = wholeFromText(token.text);
        if (!value) {
            return error(DiagnosticCode::BadIndex, token.range, {std::string(token.text)});
        }
        index = *value;
        return true;
    }

    // recursive := NAME "<" NAME ">" "." value
    bool parseRecursive(ObjectDeclaration &object)
    {
        m_lexer.take();
        const Token base = m_lexer.peek();
        object.base = Word{base.text, base.range};
        if (base.is(TokenKind::Dollar)) {
            return error(DiagnosticCode::ResultAsBase, base.range);
        }
        if (!base.is(TokenKind::Name)) {
            return expected("the name of the base", base);
        }
        m_lexer.take();
        return take(TokenKind::Greater, "\">\"") && take(TokenKind::Dot, "a dot") && parseValue(object.value);
    }

    // object := "<$>" "." value
    void parseResult()
    {
        const Token less = m_lexer.take();
        ObjectDeclaration object{{{}, less.range}};
        const bool isGood = take(TokenKind::Dollar, "\"$\"") && parseResultRest(object, less);
        add(std::move(object), isGood);
    }

    bool parseResultRest(ObjectDeclaration &object, const Token &less)
    {
        const Token greater = m_lexer.peek();
        if (!take(TokenKind::Greater, "\">\"")) {
            return false;
        }
        object.name.range = joined(less.range, greater.range);
        if (!m_lexer.peek().is(TokenKind::Dot)) {
            return error(DiagnosticCode::MissingDotAfterResult, object.name.range);
        }
        m_lexer.take();
        return parseValue(object.value);
    }

    // value := STRING(.obj) | "[" use ("," use)* "]" value | NAME | NAME INDEX
    bool parseValue(Value &value)
    {
        while (m_lexer.peek().is(TokenKind::OpenBracket)) {
            if (!parseSet(value.sets.emplace_back())) {
                return false;
            }
        }
        const Token token = m_lexer.peek();
        value.inner = {token.text, token.range};
        switch (token.kind) {
        case TokenKind::String:
            m_lexer.take();
            return parseMesh(value) && parseEnd();
        case TokenKind::UnclosedString:
            return error(DiagnosticCode::UnclosedString, token.range);
        case TokenKind::Name:
            m_lexer.take();
            return parseDepth(value) && parseEnd();
        case TokenKind::Less:
            return error(DiagnosticCode::ResultAsBase, token.range);
        default:
            return error(DiagnosticCode::ValueExpected, token.range);
        }
    }

    bool parseMesh(Value &value)
    {
        value.isMesh = true;
        value.inner.text = value.inner.text.substr(1, value.inner.text.size() - 2);
        std::string ending(
            value.inner.text.substr(value.inner.text.size() - std::min<std::size_t>(4, value.inner.text.size())));
        std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
        if (ending != ".obj") {
            return error(DiagnosticCode::NotAMeshPath, value.inner.range, {std::string(value.inner.text)});
        }
        return true;
    }

    bool parseDepth(Value &value)
    {
        const Token token = m_lexer.peek();
        if (!token.is(TokenKind::Number)) {
            return true;
        }
        std::uint64_t depth = 0;
        if (!parseIndex(depth)) {
            return false;
        }
        if (depth > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
            return error(DiagnosticCode::DepthTooLarge, token.range, {std::string(token.text)});
        }
        value.depth = depth;
        value.depthRange = token.range;
        return true;
    }

    bool parseSet(SetExpression &set)
    {
        const Token open = m_lexer.take();
        const Token first = m_lexer.peek();
        if (first.is(TokenKind::CloseBracket)) {
            return error(DiagnosticCode::EmptySet, joined(open.range, first.range));
        }
        while (true) {
            if (!parseUse(set.uses.emplace_back())) {
                return false;
            }
            const Token next = m_lexer.peek();
            if (next.is(TokenKind::CloseBracket)) {
                m_lexer.take();
                set.range = joined(open.range, next.range);
                return true;
            }
            if (!next.is(TokenKind::Comma)) {
                return expected("\",\" or \"]\"", next);
            }
            m_lexer.take();
        }
    }

    // use := "#" | NAME ("." arg)*0..3 ["."]        arg := vector INDEX | vector NAME
    bool parseUse(TransformationUse &use)
    {
        const Token token = m_lexer.peek();
        use.range = token.range;
        if (token.is(TokenKind::Hash)) {
            m_lexer.take();
            return true;
        }
        if (!token.is(TokenKind::Name)) {
            return error(DiagnosticCode::SetEntryExpected, token.range, {described(token)});
        }
        m_lexer.take();
        use.name = {token.text, token.range};
        while (m_lexer.peek(LexMode::Index).is(TokenKind::Dot)) {
            m_lexer.take(LexMode::Index);
            const Token argument = m_lexer.peek(LexMode::Index);
            if (argument.is(TokenKind::Number)) {
                return error(DiagnosticCode::BadIndex, argument.range, {std::string(argument.text)});
            }
            if (!argument.is(TokenKind::Index) && !argument.is(TokenKind::Name)) {
                break; // the trailing dot
            }
            if (use.arguments.size() == maximumParameters) {
                return error(DiagnosticCode::TooManyArguments, argument.range);
            }
            m_lexer.take(LexMode::Index);
            use.arguments.push_back({{argument.text, argument.range},
                                     argument.is(TokenKind::Index) ? wholeFromText(argument.text) : std::nullopt});
            use.range.end = argument.range.end;
        }
        return true;
    }

    LineLexer m_lexer;
    FdoSyntax &m_syntax;
};

/// What the first bytes say about an encoding that is not UTF-8; nullptr where they say nothing.
const char *foreignEncoding(std::string_view text)
{
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        return "it looks like UTF-16";
    }
    return text.substr(0, 4096).contains('\0') ? "it holds NUL bytes" : nullptr;
}

}

FdoSyntax parseFdo(std::string_view text)
{
    FdoSyntax syntax{text, {}, {}};
    if (const char *encoding = foreignEncoding(text)) {
        syntax.diagnostics.push_back({DiagnosticCode::NotUtf8, {0, 0}, {encoding}});
        return syntax;
    }
    const LineMap lines(text);
    for (std::size_t i = 0; i < lines.lineCount(); ++i) {
        SourceRange line = lines.line(i);
        if (i == 0 && text.starts_with("\xEF\xBB\xBF")) {
            line.begin += 3;
        }
        LineParser(text.substr(line.begin, line.length()), line.begin, syntax).parse();
    }
    return syntax;
}

}
