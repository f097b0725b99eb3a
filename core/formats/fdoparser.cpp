// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdosyntax.h"

#include <algorithm>
#include <limits>
#include <string>

#include "lineparser.h"
#include "numbers.h"

namespace romanesco {

namespace {

/// Parses one line. Each parse function reports at most one error and returns false after it.
class FdoLineParser : private LineParser
{
public:
    FdoLineParser(std::string_view line, std::size_t skipped, NameTable &names, FdoLine &result)
        : LineParser(line, skipped, result.diagnostics)
        , m_names(names)
        , m_result(result)
    {
    }

    // line := [ vector | transformation | object | recursive ] [comment]
    void parse()
    {
        const Token first = peek();
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
            take();
            parseNamed(first);
            return;
        default:
            error(DiagnosticCode::ExpectedDeclaration, first.range, {described(first)});
        }
    }

private:
    [[nodiscard]] Word word(const Token &token) const { return {m_names.idOf(token.text), inLine(token.range)}; }

    /// What the line declares, to be filled in.
    template<typename Node>
    Node &begin(Node node)
    {
        return m_result.declaration.emplace<Node>(std::move(node));
    }

    void parseNamed(const Token &first)
    {
        const Word name = word(first);
        const Token next = peek();
        if (next.is(TokenKind::Number) && !lexer().isBlankBeforeNext()) {
            begin(VectorDeclaration{name});
            error(DiagnosticCode::BlankAfterVectorName, {first.range.end, next.range.end}, {std::string(first.text)},
                  insertion("Insert a blank", first.range.end, " "));
        } else if (first.text == "v" && next.is(TokenKind::Less)) {
            begin(UnknownDeclaration{name});
            error(DiagnosticCode::ReservedName, first.range, {"this one"});
        } else if (first.text == "v" && isDotAndNumber()) {
            begin(VectorDeclaration{name});
            expected("a number", next, replacement("Remove the dot", next.range, ""));
        } else if (next.is(TokenKind::Number) || (first.text == "v" && !next.is(TokenKind::Dot))) {
            parseVector(begin(VectorDeclaration{name}), first.range);
        } else if (next.is(TokenKind::Dot)) {
            take();
            parseTransformationOrObject(name);
        } else if (next.is(TokenKind::Less)) {
            parseRecursive(begin(ObjectDeclaration{name}));
        } else if (looksLikeNumbers()) {
            begin(VectorDeclaration{name});
            expected("a number", next);
        } else {
            begin(UnknownDeclaration{name});
            error(DiagnosticCode::ExpectedAfterName, next.range, {described(next)});
        }
    }

    /// `v. 1 1 1`: meant as a vector, which keeps its number.
    bool isDotAndNumber() const
    {
        LineLexer ahead = lexer();
        return ahead.take().is(TokenKind::Dot) && ahead.peek().is(TokenKind::Number);
    }

    /// Whether two of the words left are numbers, as in `half nan 0 0`: meant as a vector, which keeps its number.
    bool looksLikeNumbers() const
    {
        LineLexer ahead = lexer();
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
        const Token first = take();
        if (first.text[0] >= '0' && first.text[0] <= '9') {
            const std::string_view name = first.text.substr(0, first.text.find('.'));
            const SourceRange range{first.range.begin, first.range.begin + name.size()};
            error(DiagnosticCode::NameStartsWithDigit, range, {std::string(name)},
                  insertion("Put _ before it", first.range.begin, "_"));
        } else {
            error(DiagnosticCode::ExpectedDeclaration, first.range, {described(first)});
        }
        if (peek().is(TokenKind::Number)) {
            begin(VectorDeclaration{{NameTable::nameless, inLine(first.range)}});
        }
    }

    // vector := NAME number number number | NAME number "," number "," number
    bool parseVector(VectorDeclaration &vector, SourceRange name)
    {
        bool hasComma[2] = {};
        SourceRange tight;
        SourceRange previous;
        for (int i = 0; i < 3; ++i) {
            if (i > 0) {
                const Token comma = peek();
                hasComma[i - 1] = comma.is(TokenKind::Comma);
                if (hasComma[i - 1]) {
                    take();
                    if (isBetweenDigits(comma.range.begin)) {
                        tight = {previous.begin, peek().range.end};
                    }
                }
                if (i == 2 && hasComma[0] != hasComma[1] && peek().is(TokenKind::Number)) {
                    return parseMixedCommas(tight, joined(name, peek().range));
                }
            }
            previous = peek().range;
            if (!parseNumber(vector.value[i])) {
                return false;
            }
        }
        if (peek().is(TokenKind::Comma) && isBetweenDigits(peek().range.begin)) {
            LineLexer ahead = lexer();
            ahead.take();
            return parseMixedCommas(joined(previous, ahead.peek().range), joined(name, ahead.peek().range));
        }
        return parseEnd();
    }

    /// `1,5 2`: a comma between two digits is taken for a decimal comma.
    bool parseMixedCommas(SourceRange tight, SourceRange all)
    {
        if (tight.length() == 0) {
            return error(DiagnosticCode::MixedCommas, all);
        }
        std::string number = text(tight);
        std::ranges::replace(number, ',', '.');
        return error(DiagnosticCode::DecimalComma, tight, {number}, decimalPoints(all.begin));
    }

    [[nodiscard]] bool isBetweenDigits(std::size_t at) const
    {
        const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
        return at > 0 && at + 1 < line().size() && isDigit(line()[at - 1]) && isDigit(line()[at + 1]);
    }

    /// A point for every comma between two digits.
    Fix decimalPoints(std::size_t begin) const
    {
        Fix fix{"Write decimal points", {}};
        const std::size_t end = std::min(line().find('#', begin), line().size());
        for (std::size_t comma = line().find(',', begin); comma < end; comma = line().find(',', comma + 1)) {
            if (isBetweenDigits(comma)) {
                fix.edits.push_back({{comma, comma + 1}, "."});
            }
        }
        return fix;
    }

    // transformation := NAME "." (NAME ".")*0..3 "(" out "," out "," out ")"
    // object         := NAME "." value
    void parseTransformationOrObject(const Word &name)
    {
        LineLexer ahead = lexer();
        const Token first = ahead.take();
        const Token second = ahead.peek();
        const bool isPath =
            first.is(TokenKind::Name) && hasEnding(line().substr(0, endOfWord(first.range.begin)), ".obj");
        if (isPath) { // without its quotes
            begin(ObjectDeclaration{name});
            SourceRange quoted;
            parseString(quoted);
            return;
        }
        const bool isTransformation = first.is(TokenKind::OpenParenthesis)
            || (first.is(TokenKind::Name) && (second.is(TokenKind::Dot) || second.is(TokenKind::OpenParenthesis)));
        if (isTransformation) {
            parseTransformation(begin(TransformationDeclaration{name, {}, {}}));
        } else {
            parseValue(begin(ObjectDeclaration{name}).value);
        }
    }

    /// Where blanks, a comment or the line end what begins there.
    [[nodiscard]] std::size_t endOfWord(std::size_t begin) const
    {
        return std::min(line().find_first_of(" \t\v\f#([", begin), line().size());
    }

    bool parseTransformation(TransformationDeclaration &transformation)
    {
        while (peek().is(TokenKind::Name)) {
            const Token parameter = take();
            if (transformation.parameters.size() == mostParameters) {
                return error(DiagnosticCode::TooManyParameters, parameter.range);
            }
            transformation.parameters.push_back(word(parameter));
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
        const Token token = peek();
        switch (token.kind) {
        case TokenKind::Hash:
            take();
            return true;
        case TokenKind::Name:
            take();
            result = VectorReference{word(token), std::nullopt};
            return true;
        case TokenKind::Number: {
            std::uint64_t number = 0;
            if (!parseIndex(number)) {
                return false;
            }
            result = numbered(token, number);
            return true;
        }
        default:
            return expected("a parameter, a vector or #", token);
        }
    }

    static VectorReference numbered(const Token &token, std::uint64_t number)
    {
        constexpr std::uint64_t most = std::numeric_limits<std::uint32_t>::max();
        return {{NameTable::nameless, inLine(token.range)}, static_cast<std::uint32_t>(std::min(number, most))};
    }

    // recursive := NAME "<" NAME ">" "." value
    bool parseRecursive(ObjectDeclaration &object)
    {
        take();
        const Token base = peek();
        object.base = Word{NameTable::nameless, inLine(base.range)};
        if (base.is(TokenKind::Dollar)) {
            return error(DiagnosticCode::ResultAsBase, base.range);
        }
        if (!base.is(TokenKind::Name)) {
            return expected("the name of the base", base);
        }
        object.base = word(take());
        return take(TokenKind::Greater, "\">\"") && take(TokenKind::Dot, "a dot") && parseValue(object.value);
    }

    // object := "<$>" "." value
    void parseResult()
    {
        const Token less = take();
        auto &object = begin(ObjectDeclaration{{NameTable::nameless, inLine(less.range)}});
        if (take(TokenKind::Dollar, "\"$\"")) {
            parseResultRest(object, less);
        }
    }

    bool parseResultRest(ObjectDeclaration &object, const Token &less)
    {
        const Token greater = peek();
        if (!take(TokenKind::Greater, "\">\"")) {
            return false;
        }
        const SourceRange whole = joined(less.range, greater.range);
        object.name.range = inLine(whole);
        if (!peek().is(TokenKind::Dot)) {
            return error(DiagnosticCode::MissingDotAfterResult, whole, {}, insertion("Insert a dot", whole.end, "."));
        }
        take();
        return parseValue(object.value);
    }

    // value := STRING(.obj) | "[" use ("," use)* "]" value | NAME | NAME INDEX
    bool parseValue(Value &value)
    {
        while (peek().is(TokenKind::OpenBracket)) {
            if (!parseSet(value.sets.emplace_back())) {
                return false;
            }
        }
        const Token token = peek();
        value.inner.range = inLine(token.range);
        switch (token.kind) {
        case TokenKind::String:
        case TokenKind::UnclosedString:
            return parseMesh(value) && parseEnd();
        case TokenKind::Name:
            value.inner = word(take());
            return parseDepth(value) && parseEnd();
        case TokenKind::Less:
            return error(DiagnosticCode::ResultAsBase, token.range);
        default:
            return error(DiagnosticCode::ValueExpected, token.range, {described(token)});
        }
    }

    bool parseMesh(Value &value)
    {
        SourceRange quoted;
        value.isMesh = true;
        if (!parseString(quoted)) {
            return false;
        }
        value.inner.range = inLine(quoted);
        const std::string path(unquoted(text(quoted)));
        return hasEnding(path, ".obj") || error(DiagnosticCode::NotAMeshPath, quoted, {path});
    }

    bool parseDepth(Value &value)
    {
        const Token token = peek();
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
        value.depthRange = inLine(token.range);
        return true;
    }

    bool parseSet(SetExpression &set)
    {
        const Token open = take();
        const Token first = peek();
        if (first.is(TokenKind::CloseBracket)) {
            return error(DiagnosticCode::EmptySet, joined(open.range, first.range), {},
                         insertion("Put # into it", open.range.end, "#"));
        }
        while (true) {
            if (!parseUse(set.uses.emplace_back())) {
                return false;
            }
            const Token next = peek();
            if (next.is(TokenKind::CloseBracket)) {
                take();
                set.range = inLine(joined(open.range, next.range));
                return true;
            }
            if (!next.is(TokenKind::Comma)) {
                return expected("\",\" or \"]\"", next, fixAfterUse(next));
            }
            take();
        }
    }

    /// Before another use a comma is missing, before a value or the end a ].
    std::optional<Fix> fixAfterUse(const Token &next) const
    {
        LineLexer ahead = lexer();
        ahead.take();
        const Token second = ahead.peek(LexMode::Index);
        const bool isName = next.is(TokenKind::Name);
        if (isName
            && (second.is(TokenKind::Dot) || second.is(TokenKind::Comma) || second.is(TokenKind::CloseBracket))) {
            return insertion("Insert the missing comma", lastEnd(), ",");
        }
        if (isName || next.is(TokenKind::String) || next.is(TokenKind::OpenBracket) || next.is(TokenKind::EndOfLine)) {
            return insertion("Insert the missing ]", lastEnd(), "]");
        }
        return std::nullopt;
    }

    // use := "#" | NAME ("." arg)*0..3 ["."]        arg := vector INDEX | vector NAME
    bool parseUse(TransformationUse &use)
    {
        const Token token = peek();
        use.range = inLine(token.range);
        if (token.is(TokenKind::Hash)) {
            take();
            return true;
        }
        if (!token.is(TokenKind::Name)) {
            return error(DiagnosticCode::SetEntryExpected, token.range, {described(token)});
        }
        use.name = word(take());
        while (peek(LexMode::Index).is(TokenKind::Dot)) {
            take(LexMode::Index);
            const Token argument = peek(LexMode::Index);
            if (argument.is(TokenKind::Number)) {
                return error(DiagnosticCode::BadIndex, argument.range, {std::string(argument.text)});
            }
            if (!argument.is(TokenKind::Index) && !argument.is(TokenKind::Name)) {
                break; // the trailing dot
            }
            if (use.arguments.size() == mostParameters) {
                return error(DiagnosticCode::TooManyArguments, argument.range);
            }
            take(LexMode::Index);
            use.arguments.push_back(argument.is(TokenKind::Index)
                                        ? numbered(argument, wholeFromText(argument.text).value_or(0))
                                        : VectorReference{word(argument), std::nullopt});
            use.range.end = inLine(argument.range).end;
        }
        return true;
    }

    NameTable &m_names;
    FdoLine &m_result;
};

}

FdoLine parseFdoLine(std::string_view line, std::size_t skipped, NameTable &names)
{
    FdoLine result;
    FdoLineParser(line, skipped, names, result).parse();
    result.isBad = hasErrors(result.diagnostics);
    return result;
}

void FdoSyntax::setText(std::string text)
{
    ParsedLines::setText(std::move(text), [this](std::string_view line, std::size_t skipped) {
        return parseFdoLine(line, skipped, m_names);
    });
}

}
