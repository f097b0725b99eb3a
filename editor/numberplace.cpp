// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "numberplace.h"

#include "core/language/fdowords.h"
#include "core/text/lexer.h"
#include "languagetext.h"

namespace romanesco {

namespace {

using Found = std::optional<NumberPlace>;

Found place(std::string_view text, SourceRange range, std::optional<double> leastWhole)
{
    const std::optional<WrittenNumber> number = writtenNumber(text, range);
    return number ? Found({*number, leastWhole}) : std::nullopt;
}

/// Of the numbers that stand in a line from an offset on, the one that is touched.
Found plainNumber(const LineMap &map, std::size_t line, std::size_t skipped, std::size_t end, std::size_t offset)
{
    const std::string_view words = map.lineText(line).substr(0, end).substr(std::min(skipped, end));
    LineLexer lexer(words, map.start(line) + skipped);
    for (Token token = lexer.take(); !token.is(TokenKind::EndOfLine); token = lexer.take()) {
        if (token.is(TokenKind::Number) && token.range.touches(offset)) {
            return place(map.text(), token.range, std::nullopt);
        }
    }
    return std::nullopt;
}

Found numberIn(const FdoSyntax &syntax, std::size_t line, std::size_t offset)
{
    const FdoLine &parsed = syntax.line(line);
    if (std::holds_alternative<VectorDeclaration>(parsed.declaration)) {
        // No string and no # but the comment's stands in a vector.
        const std::size_t end = std::min(syntax.map().lineText(line).find('#'), syntax.map().lineText(line).size());
        return plainNumber(syntax.map(), line, syntax.skipped(line), end, offset);
    }
    Found found;
    forEachWord(parsed, [&](const LineWord &word) {
        const SourceRange range = syntax.range(line, word.word.range);
        const bool isDepth = word.role == WordRole::Depth;
        if (range.touches(offset) && (word.number || isDepth)) {
            found = place(syntax.text(), range, isDepth ? 0.0 : 1.0);
        }
    });
    return found;
}

Found numberIn(const SdoSyntax &syntax, std::size_t line, std::size_t offset)
{
    return plainNumber(syntax.map(), line, syntax.skipped(line), syntax.line(line).range.end, offset);
}

Found numberAt(const auto &syntax, std::size_t offset)
{
    const std::size_t line = syntax.map().lineAt(offset);
    return line < syntax.lineCount() ? numberIn(syntax, line, offset) : std::nullopt;
}

}

std::optional<NumberPlace> numberAt(LanguageText &text, int position)
{
    const std::size_t offset = text.offset(position);
    if (const FdoDocument *fdo = text.fdo()) {
        return numberAt(fdo->syntax, offset);
    }
    const SdoSyntax *sdo = text.sdo();
    return sdo ? numberAt(*sdo, offset) : std::nullopt;
}

TextEdit stepped(const NumberPlace &place, int steps, bool isFiner)
{
    if (!place.leastWhole) {
        return stepped(place.number, steps, isFiner ? 1 : 0);
    }
    return place.number.value + steps < *place.leastWhole ? withValue(place.number, *place.leastWhole)
                                                          : stepped(place.number, steps);
}

}
