// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "structure.h"

#include <algorithm>

#include "core/text/lexer.h"
#include "core/text/unicode.h"

namespace romanesco {

namespace {

const Value *valueIn(const FdoSyntax &syntax, std::size_t line)
{
    const auto *object = std::get_if<ObjectDeclaration>(&syntax.line(line).declaration);
    return object ? &object->value : nullptr;
}

SymbolKind kindOf(const VectorDeclaration &)
{
    return SymbolKind::Vector;
}
SymbolKind kindOf(const TransformationDeclaration &)
{
    return SymbolKind::Transformation;
}
SymbolKind kindOf(const ObjectDeclaration &node)
{
    return node.base ? SymbolKind::Recursive : SymbolKind::Object;
}
SymbolKind kindOf(const UnknownDeclaration &)
{
    return SymbolKind::Unknown;
}

/// What a whole line holds.
enum class LineKind { Blank, Comment, Code };

LineKind kindOf(std::string_view line)
{
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == line.npos) {
        return LineKind::Blank;
    }
    return line[first] == '#' ? LineKind::Comment : LineKind::Code;
}

}

std::vector<OutlineEntry> outline(const FdoDocument &document)
{
    const FdoSyntax &syntax = document.syntax;
    std::vector<OutlineEntry> entries;
    for (std::size_t line = 0; line < syntax.lineCount(); ++line) {
        const auto add = [&](const auto &node) {
            if constexpr (requires { node.name; }) {
                const SymbolKind kind = kindOf(node);
                const bool isPlain = kind == SymbolKind::Vector
                    && (node.name.name == syntax.plainVector() || node.name.name == NameTable::nameless);
                if (!isPlain) {
                    const bool isResult = node.name.name == NameTable::nameless;
                    entries.push_back(
                        {isResult ? "<$>" : syntax.name(node.name), kind, syntax.range(line, node.name.range), line});
                }
            }
        };
        std::visit(add, syntax.line(line).declaration);
    }
    return entries;
}

std::vector<FoldingRange> foldingRanges(const LineMap &lines)
{
    std::vector<FoldingRange> ranges;
    bool isInSection = false;
    bool isAfterBlank = true;
    for (std::size_t i = 0; i < lines.lineCount(); ++i) {
        const bool hasMark = i == 0 && lines.text().starts_with(byteOrderMark);
        const LineKind kind = kindOf(lines.lineText(i).substr(hasMark ? byteOrderMark.size() : 0));
        if (kind == LineKind::Comment && isAfterBlank) {
            ranges.push_back({i, i});
            isInSection = true;
        } else if (kind != LineKind::Blank && isInSection) {
            ranges.back().last = i;
        }
        isAfterBlank = kind == LineKind::Blank;
    }
    std::erase_if(ranges, [](const FoldingRange &range) { return range.first == range.last; });
    return ranges;
}

std::vector<Inlay> inlays(const FdoDocument &document, std::size_t first, std::size_t end)
{
    std::vector<Inlay> found;
    const std::vector<VectorEntry> &vectors = document.model.vectors;
    auto at = std::ranges::lower_bound(vectors, first, {}, &VectorEntry::line);
    for (; at != vectors.end() && at->line < end; ++at) {
        const std::size_t start = document.syntax.map().start(at->line);
        LineLexer lexer(document.syntax.map().lineText(at->line), start);
        std::size_t last = start;
        for (Token token = lexer.take(); !token.is(TokenKind::EndOfLine) && !token.is(TokenKind::Hash);
             token = lexer.take()) {
            last = token.range.end;
        }
        found.push_back({last, static_cast<std::uint32_t>(at - vectors.begin()) + 1});
    }
    return found;
}

std::vector<DepthNumber> depthNumbers(const FdoDocument &document)
{
    const FdoSyntax &syntax = document.syntax;
    std::vector<DepthNumber> numbers;
    for (std::size_t line = 0; line < syntax.lineCount(); ++line) {
        const Value *value = valueIn(syntax, line);
        if (value && value->depth) {
            numbers.push_back({syntax.name(value->inner), *value->depth, syntax.range(line, value->depthRange)});
        }
    }
    return numbers;
}

TextEdits withDepth(const FdoDocument &document, std::uint64_t depth)
{
    const std::optional<std::uint32_t> line = document.model.depthLine();
    const Value *value = line ? valueIn(document.syntax, *line) : nullptr;
    if (!value) {
        return {};
    }
    return {{document.syntax.range(*line, value->depthRange), std::to_string(depth)}};
}

}
