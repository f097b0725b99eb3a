// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <array>
#include <cmath>
#include <format>

#include "core/text/lexer.h"
#include "fdowords.h"
#include "hover.h"
#include "levelfacts.h"
#include "occurrences.h"
#include "plainwords.h"

namespace romanesco {

namespace {

constexpr std::array partNames{"position", "rotation", "scale"};
constexpr const char *badLine = "its line has an error";

/// 244,140,625
std::string grouped(std::string digits)
{
    for (std::size_t at = digits.size(); at > 3; at -= 3) {
        digits.insert(at - 3, ",");
    }
    return digits;
}

std::string wholeWords(std::uint64_t number)
{
    return grouped(std::to_string(number));
}

/// All digits up to 10^15, from there on ~2.44e20.
std::string countWords(const Count &count)
{
    const double magnitude = count.log10();
    if (magnitude < 15.0) {
        return grouped(count.toString());
    }
    if (!count.isExact()) {
        return count.toString();
    }
    const double exponent = std::floor(magnitude);
    const std::string mantissa = std::format("{:.2f}", std::pow(10.0, magnitude - exponent));
    const bool isRoundedUp = mantissa == "10.00";
    return std::format("~{}e{:.0f}", isRoundedUp ? "1.00" : mantissa, exponent + (isRoundedUp ? 1.0 : 0.0));
}

std::string sizeWords(const LevelFacts &facts)
{
    if (facts.levelCount == 0) {
        return "no levels";
    }
    std::string text = facts.levelCount == 1 ? "level size " : "level sizes ";
    for (std::size_t i = 0; i < facts.sizes.size(); ++i) {
        text += std::format("{}{}", i == 0 ? "" : ", ", facts.sizes[i]);
    }
    if (facts.levelCount > facts.sizes.size()) {
        text += std::format(", … ({} levels)", wholeWords(facts.levelCount));
    }
    return text;
}

class FdoHoverer
{
public:
    FdoHoverer(const FdoDocument &document, std::uint32_t line)
        : m_document(document)
        , m_syntax(document.syntax)
        , m_model(document.model)
        , m_line(line)
    {
    }

    std::optional<Hover> at(std::size_t offset)
    {
        std::optional<LineWord> touched;
        forEachWord(m_syntax.line(m_line), [&](const LineWord &word) {
            if (!touched && m_syntax.range(m_line, word.word.range).touches(offset)) {
                touched = word;
            }
        });
        std::optional<Hover> hover = touched ? ofWord(*touched) : std::nullopt;
        if (hover) {
            return hover;
        }
        if (const TransformationUse *use = useAt(offset)) {
            return ofUse(*use);
        }
        return ofVectorLine(offset);
    }

private:
    [[nodiscard]] std::string_view name(NameId id) const { return m_syntax.names()[id]; }

    std::optional<Hover> ofWord(const LineWord &word)
    {
        const SourceRange range = m_syntax.range(m_line, word.word.range);
        if (word.role == WordRole::Depth) {
            return ofDepth(range);
        }
        if (word.role == WordRole::UseName) {
            return std::nullopt; // the whole use says more
        }
        const std::optional<Entity> entity = entityOf(m_document, m_line, word);
        if (!entity) {
            return std::nullopt;
        }
        Hover hover{range, {}, {}};
        switch (entity->kind) {
        case Entity::Kind::Vector:
            describeVector(entity->index, hover);
            break;
        case Entity::Kind::Transformation:
            describeTransformation(entity->line, hover);
            break;
        case Entity::Kind::Object:
        case Entity::Kind::Recursive:
            describeObject(nodeIn(entity->line), hover);
            break;
        case Entity::Kind::Unknown:
            hover.title = m_syntax.words(m_line, word.word.range);
            hover.lines = {badLine};
            break;
        case Entity::Kind::Parameter:
            describeParameter(entity->index, hover);
            break;
        case Entity::Kind::Result:
            describeObject(nodeIn(m_line), hover);
            break;
        case Entity::Kind::Path:
            hover.title = entity->path;
            hover.lines = {"the base mesh"};
            break;
        }
        return hover;
    }

    // ---- Vectors and transformations

    void describeVector(std::uint32_t index, Hover &hover) const
    {
        const VectorEntry &vector = m_model.vectors[index];
        const Word &word = std::get<VectorDeclaration>(m_syntax.line(vector.line).declaration).name;
        const bool isNamed = word.name != NameTable::nameless && word.name != m_syntax.plainVector();
        hover.title = std::format("{}vector {}", isNamed ? m_syntax.name(word) + ", " : std::string(), index + 1);
        hover.lines = {vector.isBad ? badLine : plainWords(vector.value)};
    }

    /// The numbers of a vector's line show what its name does.
    std::optional<Hover> ofVectorLine(std::size_t offset) const
    {
        const auto *vector = std::get_if<VectorDeclaration>(&m_syntax.line(m_line).declaration);
        if (!vector) {
            return std::nullopt;
        }
        SourceRange whole = m_syntax.range(m_line, vector->name.range);
        const std::size_t end = m_syntax.map().line(m_line).end;
        LineLexer lexer(std::string_view(m_syntax.text()).substr(whole.end, end - whole.end), whole.end);
        for (Token token = lexer.take(); !token.is(TokenKind::EndOfLine) && !token.is(TokenKind::Hash);
             token = lexer.take()) {
            whole.end = token.range.end;
        }
        if (!whole.touches(offset)) {
            return std::nullopt;
        }
        const auto entry = std::ranges::lower_bound(m_model.vectors, m_line, {}, &VectorEntry::line);
        Hover hover{whole, {}, {}};
        describeVector(static_cast<std::uint32_t>(entry - m_model.vectors.begin()), hover);
        return hover;
    }

    void describeTransformation(std::uint32_t line, Hover &hover) const
    {
        const auto &node = std::get<TransformationDeclaration>(m_syntax.line(line).declaration);
        hover.title = "transformation " + m_syntax.name(node.name);
        for (const Word &parameter : node.parameters) {
            hover.title += '.' + m_syntax.name(parameter);
        }
        if (m_syntax.line(line).isBad) {
            hover.lines = {badLine};
            return;
        }
        for (std::size_t i = 0; i < partNames.size(); ++i) {
            hover.lines.push_back(std::format("{} {}", partNames[i], partWords(node.results[i], line)));
        }
    }

    /// The value of a vector; else as it is written.
    [[nodiscard]] std::string partWords(const std::optional<VectorReference> &part, std::uint32_t line) const
    {
        if (!part) {
            return "#";
        }
        const std::optional<Entity> entity = entityOf(m_document, line, {WordRole::Part, part->word, part->number});
        if (entity && entity->kind == Entity::Kind::Vector && !m_model.vectors[entity->index].isBad) {
            return plainWords(m_model.vectors[entity->index].value);
        }
        return std::string(m_syntax.words(line, part->word.range));
    }

    void describeParameter(std::uint32_t index, Hover &hover) const
    {
        const auto &node = std::get<TransformationDeclaration>(m_syntax.line(m_line).declaration);
        const NameId parameter = node.parameters[index].name;
        hover.title = std::format("parameter {} of {}", name(parameter), name(node.name.name));
        std::string places;
        for (std::size_t i = 0; i < partNames.size(); ++i) {
            const std::optional<VectorReference> &part = node.results[i];
            if (part && !part->number && part->word.name == parameter) {
                places += (places.empty() ? "the " : ", the ") + std::string(partNames[i]);
            }
        }
        hover.lines = {places.empty() ? "not used" : places};
    }

    // ---- Uses

    [[nodiscard]] const TransformationUse *useAt(std::size_t offset) const
    {
        const auto *object = std::get_if<ObjectDeclaration>(&m_syntax.line(m_line).declaration);
        if (!object) {
            return nullptr;
        }
        for (const SetExpression &set : object->value.sets) {
            for (const TransformationUse &use : set.uses) {
                if (!use.isIdentity() && m_syntax.range(m_line, use.range).touches(offset)) {
                    return &use;
                }
            }
        }
        return nullptr;
    }

    std::optional<Hover> ofUse(const TransformationUse &use) const
    {
        const std::optional<TransformParts> parts = m_model.parts(use, m_line);
        Hover hover{m_syntax.range(m_line, use.range), std::string(m_syntax.words(m_line, use.range)), {}};
        if (parts) {
            hover.lines = transformWords(*parts);
            return hover;
        }
        // with wrong arguments it still says what it takes
        const Symbol *symbol = m_model.find(use.name.name, m_line);
        if (!symbol || symbol->kind != SymbolKind::Transformation) {
            return std::nullopt;
        }
        describeTransformation(symbol->line, hover);
        return hover;
    }

    // ---- Objects

    [[nodiscard]] std::uint32_t nodeIn(std::uint32_t line) const
    {
        std::uint32_t first = 0;
        std::uint32_t last = m_model.forest.size();
        while (first < last) {
            const std::uint32_t middle = first + (last - first) / 2;
            if (m_model.forest[middle].line < line) {
                first = middle + 1;
            } else {
                last = middle;
            }
        }
        return first;
    }

    void describeObject(std::uint32_t index, Hover &hover) const
    {
        const ObjectNode &node = m_model.forest[index];
        const std::string_view own = name(node.name);
        if (node.name == NameTable::nameless) {
            hover.title = "<$>, the result";
        } else {
            hover.title = std::format("{} {}", node.isRecursive ? "recursive" : "object", own);
        }
        if (node.isBad) {
            hover.lines = {badLine};
            return;
        }
        if (node.isRecursive) {
            hover.title += std::format(" around {}", name(m_model.forest[node.base].name));
        }
        addLevels(index, hover.lines);
        const std::uint32_t mesh = m_model.forest[m_model.forest.meshNode(index)].line;
        const Value &value = std::get<ObjectDeclaration>(m_syntax.line(mesh).declaration).value;
        hover.lines.push_back(std::format("mesh {}", m_syntax.words(mesh, value.inner.range)));
    }

    void addLevels(std::uint32_t index, std::vector<std::string> &lines) const
    {
        const std::optional<LevelFacts> facts = levelFacts(m_document, index);
        if (!facts) {
            lines.push_back("too many levels to count here");
            return;
        }
        lines.push_back((m_model.forest[index].isRecursive ? "one iteration: " : "") + sizeWords(*facts));
        const std::string count = countWords(facts->instances);
        const char *const noun = count == "1" ? "instance" : "instances";
        if (facts->iteration) {
            lines.push_back(std::format("t = {}, d = {}", countWords(facts->iteration->transforms),
                                        wholeWords(facts->iteration->depth)));
        }
        lines.push_back(std::format("{} {} as written", count, noun));
    }

    std::optional<Hover> ofDepth(SourceRange range) const
    {
        const Value &value = std::get<ObjectDeclaration>(m_syntax.line(m_line).declaration).value;
        const Symbol *symbol = m_model.find(value.inner.name, m_line);
        if (!symbol || symbol->kind != SymbolKind::Recursive) {
            return std::nullopt;
        }
        Hover hover{range, std::format("depth {} of {}", wholeWords(*value.depth), name(value.inner.name)), {}};
        const ObjectNode &node = m_model.forest[symbol->index];
        if (node.isBad) {
            hover.lines = {badLine};
            return hover;
        }
        hover.lines.push_back(std::format("{} {} around {}", wholeWords(*value.depth),
                                          *value.depth == 1 ? "iteration" : "iterations",
                                          name(m_model.forest[node.base].name)));
        if (const std::optional<LevelFacts> facts = levelFacts(m_document, symbol->index)) {
            hover.lines.push_back(std::format("each multiplies the instances by {}", countWords(facts->instances)));
        }
        return hover;
    }

    const FdoDocument &m_document;
    const FdoSyntax &m_syntax;
    const FdoModel &m_model;
    std::uint32_t m_line;
};

}

std::optional<Hover> hover(const FdoDocument &document, std::size_t offset)
{
    const std::size_t line = document.syntax.map().lineAt(offset);
    if (line >= document.syntax.lineCount()) {
        return std::nullopt;
    }
    return FdoHoverer(document, static_cast<std::uint32_t>(line)).at(offset);
}

}
