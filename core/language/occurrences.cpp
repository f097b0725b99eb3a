// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "occurrences.h"

#include <algorithm>

#include "core/formats/lineparser.h"
#include "fdowords.h"

namespace romanesco {

namespace {

using Kind = Entity::Kind;

Entity vectorEntity(const FdoModel &model, std::uint32_t index)
{
    return {Kind::Vector, model.vectors[index].line, index};
}

/// The vector that a line declares.
Entity vectorDeclaredIn(const FdoModel &model, std::uint32_t line)
{
    const auto at = std::ranges::lower_bound(model.vectors, line, {}, &VectorEntry::line);
    return vectorEntity(model, static_cast<std::uint32_t>(at - model.vectors.begin()));
}

std::optional<Entity> vectorByNumber(const FdoModel &model, std::uint32_t line, std::uint32_t number)
{
    if (number == 0 || number > model.vectors.size() || model.vectors[number - 1].line >= line) {
        return std::nullopt;
    }
    return vectorEntity(model, number - 1);
}

std::optional<Entity> byName(const FdoModel &model, std::uint32_t line, NameId name)
{
    const Symbol *symbol = model.find(name, line);
    if (!symbol) {
        return std::nullopt;
    }
    switch (symbol->kind) {
    case SymbolKind::Vector:
        return symbol->repeatLine < line ? std::nullopt : std::optional(vectorEntity(model, symbol->index));
    case SymbolKind::Transformation:
        return Entity{Kind::Transformation, symbol->line};
    case SymbolKind::Object:
        return Entity{Kind::Object, symbol->line};
    case SymbolKind::Recursive:
        return Entity{Kind::Recursive, symbol->line};
    case SymbolKind::Undeclared:
    case SymbolKind::Unknown:
        break;
    }
    return Entity{Kind::Unknown, symbol->line};
}

std::optional<Entity> parameterByName(const FdoLine &line, std::uint32_t number, NameId name)
{
    const auto &parameters = std::get<TransformationDeclaration>(line.declaration).parameters;
    const auto at = std::ranges::find(parameters, name, &Word::name);
    if (at == parameters.end()) {
        return std::nullopt;
    }
    return Entity{Kind::Parameter, number, static_cast<std::uint32_t>(at - parameters.begin())};
}

bool isDeclaration(WordRole role)
{
    switch (role) {
    case WordRole::VectorName:
    case WordRole::TransformationName:
    case WordRole::ParameterName:
    case WordRole::ObjectName:
    case WordRole::ResultName:
    case WordRole::UnknownName:
        return true;
    default:
        return false;
    }
}

std::optional<Occurrence> occurrenceOf(const FdoDocument &document, std::uint32_t line, const LineWord &word)
{
    std::optional<Entity> entity = entityOf(document, line, word);
    if (!entity) {
        return std::nullopt;
    }
    return Occurrence{document.syntax.range(line, word.word.range), std::move(*entity), isDeclaration(word.role),
                      word.word.name != NameTable::nameless};
}

void addOccurrences(const FdoDocument &document, std::uint32_t line, const Entity &entity,
                    std::vector<Occurrence> &found)
{
    forEachWord(document.syntax.line(line), [&](const LineWord &word) {
        const bool isPath = word.role == WordRole::Path;
        if (isPath != (entity.kind == Kind::Path)) {
            return; // before a path is copied
        }
        std::optional<Occurrence> occurrence = occurrenceOf(document, line, word);
        if (occurrence && occurrence->entity == entity) {
            found.push_back(std::move(*occurrence));
        }
    });
}

}

std::optional<Entity> entityOf(const FdoDocument &document, std::uint32_t line, const LineWord &word)
{
    const auto &[syntax, model] = document;
    switch (word.role) {
    case WordRole::VectorName:
        return vectorDeclaredIn(model, line);
    case WordRole::TransformationName:
        return Entity{Kind::Transformation, line};
    case WordRole::ParameterName:
        return Entity{Kind::Parameter, line, word.parameter};
    case WordRole::ObjectName: {
        const bool isRecursive = std::get<ObjectDeclaration>(syntax.line(line).declaration).base.has_value();
        return Entity{isRecursive ? Kind::Recursive : Kind::Object, line};
    }
    case WordRole::ResultName:
        return Entity{Kind::Result};
    case WordRole::UnknownName:
        return Entity{Kind::Unknown, line};
    case WordRole::Path:
        return Entity{Kind::Path, 0, 0, std::string(unquoted(syntax.words(line, word.word.range)))};
    case WordRole::Depth:
        return std::nullopt;
    case WordRole::Part:
        if (const auto parameter =
                word.number ? std::nullopt : parameterByName(syntax.line(line), line, word.word.name)) {
            return parameter;
        }
        break;
    case WordRole::BaseName:
    case WordRole::UseName:
    case WordRole::Argument:
    case WordRole::InnerName:
        break;
    }
    return word.number ? vectorByNumber(model, line, *word.number) : byName(model, line, word.word.name);
}

std::optional<Occurrence> occurrenceAt(const FdoDocument &document, std::size_t offset)
{
    const std::size_t line = document.syntax.map().lineAt(offset);
    std::optional<Occurrence> found;
    if (line >= document.syntax.lineCount()) {
        return found;
    }
    forEachWord(document.syntax.line(line), [&](const LineWord &word) {
        if (!found && document.syntax.range(line, word.word.range).touches(offset)) {
            found = occurrenceOf(document, static_cast<std::uint32_t>(line), word);
        }
    });
    return found;
}

std::vector<Occurrence> occurrences(const FdoDocument &document, const Entity &entity)
{
    const bool isLocal = entity.kind == Kind::Parameter;
    const std::size_t first = isLocal ? entity.line : 0;
    const std::size_t count = document.syntax.lineCount();
    const std::size_t end = isLocal ? std::min<std::size_t>(first + 1, count) : count;
    std::vector<Occurrence> found;
    for (std::size_t line = first; line < end; ++line) {
        addOccurrences(document, static_cast<std::uint32_t>(line), entity, found);
    }
    return found;
}

std::optional<SourceRange> declaration(const FdoDocument &document, const Entity &entity)
{
    std::uint32_t line = entity.line;
    if (entity.kind == Kind::Result) {
        const ObjectForest &forest = document.model.forest;
        std::uint32_t node = 0;
        while (node < forest.size() && forest[node].name != NameTable::nameless) {
            ++node;
        }
        if (node == forest.size()) {
            return std::nullopt;
        }
        line = forest[node].line;
    }
    std::vector<Occurrence> found;
    if (line < document.syntax.lineCount()) {
        addOccurrences(document, line, entity, found);
    }
    const auto at = std::ranges::find(found, true, &Occurrence::isDeclaration);
    return at == found.end() ? std::nullopt : std::optional(at->range);
}

}
