// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fdomodel.h"

namespace romanesco {

const char *described(SymbolKind kind)
{
    switch (kind) {
    case SymbolKind::Vector:
        return "a vector";
    case SymbolKind::Transformation:
        return "a transformation";
    case SymbolKind::Object:
        return "an object";
    case SymbolKind::Recursive:
        return "a recursive";
    case SymbolKind::Undeclared:
    case SymbolKind::Unknown:
        break;
    }
    return "unknown";
}

const Symbol *FdoModel::find(NameId name, std::size_t line) const
{
    if (name >= symbols.size()) {
        return nullptr;
    }
    const Symbol &symbol = symbols[name];
    return symbol.kind != SymbolKind::Undeclared && symbol.line < line ? &symbol : nullptr;
}

std::optional<std::uint32_t> FdoModel::vector(const VectorReference &reference, std::size_t line) const
{
    std::uint32_t index = 0;
    if (reference.number) {
        if (*reference.number == 0 || *reference.number > vectors.size()) {
            return std::nullopt;
        }
        index = *reference.number - 1;
    } else {
        const Symbol *symbol = find(reference.word.name, line);
        if (!symbol || symbol->kind != SymbolKind::Vector || symbol->repeatLine < line) {
            return std::nullopt;
        }
        index = symbol->index;
    }
    return vectors[index].isBad || vectors[index].line >= line ? std::nullopt : std::optional(index);
}

std::optional<TransformParts> FdoModel::parts(const TransformationUse &use, std::size_t line) const
{
    const Symbol *symbol = use.isIdentity() ? nullptr : find(use.name.name, line);
    if (!symbol || symbol->kind != SymbolKind::Transformation || symbol->isBad) {
        return std::nullopt;
    }
    const TransformationEntry &entry = transformations[symbol->index];
    if (use.arguments.size() != entry.parameterCount) {
        return std::nullopt;
    }
    std::array<std::uint32_t, mostParameters> arguments{};
    for (std::size_t i = 0; i < use.arguments.size(); ++i) {
        const std::optional<std::uint32_t> argument = vector(use.arguments[i], line);
        if (!argument) {
            return std::nullopt;
        }
        arguments[i] = *argument;
    }
    TransformParts parts;
    const std::array<glm::dvec3 *, 3> places{&parts.position, &parts.rotation, &parts.scale};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const PartSource &source = entry.parts[i];
        if (source.kind != PartSource::Kind::Identity) {
            const bool isVector = source.kind == PartSource::Kind::Vector;
            *places[i] = vectors[isVector ? source.index : arguments[source.index]].value;
        }
    }
    return parts;
}

std::optional<std::uint32_t> FdoModel::depthLine() const
{
    for (std::uint32_t at = result; at != ObjectNode::none; at = forest[at].next) {
        if (forest[at].repeated != ObjectNode::none) {
            return forest[at].line;
        }
    }
    return std::nullopt;
}

}
