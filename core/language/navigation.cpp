// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "navigation.h"

#include <algorithm>
#include <format>

#include "core/formats/lineparser.h"
#include "core/text/unicode.h"
#include "fdowords.h"

namespace romanesco {

namespace {

using Kind = Entity::Kind;
using Refusal = std::optional<std::string>;

bool isName(std::string_view text)
{
    return !text.empty() && isNameStart(firstCodePoint(text).value) && nameLength(text) == text.size();
}

/// Why the thing itself keeps its name, or has none.
Refusal whyKept(const std::optional<Occurrence> &occurrence)
{
    if (!occurrence) {
        return "No name that is declared stands here.";
    }
    switch (occurrence->entity.kind) {
    case Kind::Result:
        return "<$> is the result and cannot be renamed.";
    case Kind::Path:
        return "A file is renamed on the disk, not in the text.";
    default:
        return std::nullopt;
    }
}

Refusal whyNoName(std::string_view name)
{
    if (!isName(name)) {
        return std::format("\"{}\" is not a name: a letter or _, then letters, digits and _.", name);
    }
    if (name == "v") {
        return "v is the name that all vectors may have; choose another.";
    }
    return std::nullopt;
}

const TransformationDeclaration *transformationIn(const FdoDocument &document, std::uint32_t line)
{
    return std::get_if<TransformationDeclaration>(&document.syntax.line(line).declaration);
}

bool hasParameter(const TransformationDeclaration &node, NameId name)
{
    return std::ranges::contains(node.parameters, name, &Word::name);
}

/// A parameter must differ from the others of its line, and from the vectors that the line refers to by name.
Refusal whyNotForParameter(const FdoDocument &document, const Entity &entity, NameId name)
{
    const TransformationDeclaration &node = *transformationIn(document, entity.line);
    const std::string_view text = document.syntax.names()[name];
    if (hasParameter(node, name)) {
        return std::format("This transformation has a parameter {} already.", text);
    }
    const bool isUsed = std::ranges::any_of(node.results, [&](const std::optional<VectorReference> &part) {
        return part && !part->number && part->word.name == name;
    });
    return isUsed
        ? Refusal(std::format("This transformation uses the vector {}, which the parameter would hide.", text))
        : std::nullopt;
}

/// There is one name space for all but parameters; and a parameter must not catch what means a vector.
Refusal whyNotForDeclared(const FdoDocument &document, const std::vector<Occurrence> &found, NameId name)
{
    const std::string_view text = document.syntax.names()[name];
    const Symbol &symbol = document.model.symbols[name];
    if (symbol.kind != SymbolKind::Undeclared) {
        return std::format("{} is declared already, in line {}.", text, symbol.line + 1);
    }
    for (const Occurrence &occurrence : found) {
        const auto line = static_cast<std::uint32_t>(document.syntax.map().lineAt(occurrence.range.begin));
        const TransformationDeclaration *node = occurrence.isDeclaration ? nullptr : transformationIn(document, line);
        if (node && occurrence.isName && hasParameter(*node, name)) {
            return std::format("In line {} the parameter {} would hide it.", line + 1, text);
        }
    }
    return std::nullopt;
}

}

std::optional<Target> definition(const FdoDocument &document, std::size_t offset)
{
    const std::optional<Occurrence> occurrence = occurrenceAt(document, offset);
    if (!occurrence) {
        return std::nullopt;
    }
    if (occurrence->entity.kind == Kind::Path) {
        return Target{occurrence->range, occurrence->entity.path};
    }
    const std::optional<SourceRange> range = declaration(document, occurrence->entity);
    return range ? std::optional(Target{*range}) : std::nullopt;
}

std::optional<Target> definition(const SdoSyntax &syntax, std::size_t offset)
{
    const std::size_t line = syntax.map().lineAt(offset);
    const PlacedFile *file = line < syntax.lineCount() ? syntax.line(line).file() : nullptr;
    if (!file || file->path.length() == 0 || !syntax.range(line, file->path).touches(offset)) {
        return std::nullopt;
    }
    return Target{syntax.range(line, file->path), std::string(unquoted(syntax.words(line, file->path)))};
}

std::vector<Occurrence> uses(const FdoDocument &document, std::size_t offset)
{
    const std::optional<Occurrence> occurrence = occurrenceAt(document, offset);
    return occurrence ? occurrences(document, occurrence->entity) : std::vector<Occurrence>();
}

std::optional<SourceRange> renamable(const FdoDocument &document, std::size_t offset)
{
    const std::optional<Occurrence> occurrence = occurrenceAt(document, offset);
    if (whyKept(occurrence)) {
        return std::nullopt;
    }
    if (occurrence->isName) {
        return occurrence->range;
    }
    const std::optional<SourceRange> declared = declaration(document, occurrence->entity);
    const std::optional<Occurrence> name = declared ? occurrenceAt(document, declared->begin) : std::nullopt;
    return name && name->isName ? declared : std::nullopt;
}

std::expected<TextEdits, std::string> rename(const FdoDocument &document, std::size_t offset, std::string_view newName)
{
    const std::optional<Occurrence> occurrence = occurrenceAt(document, offset);
    if (const Refusal why = whyKept(occurrence)) {
        return std::unexpected(*why);
    }
    const std::vector<Occurrence> found = occurrences(document, occurrence->entity);
    const auto declared = std::ranges::find(found, true, &Occurrence::isDeclaration);
    if (declared == found.end() || !declared->isName) {
        return std::unexpected("This vector's line has no name yet.");
    }
    const std::string_view text = document.syntax.text();
    if (text.substr(declared->range.begin, declared->range.length()) == newName) {
        return TextEdits();
    }
    Refusal why = whyNoName(newName);
    if (const std::optional<NameId> name = document.syntax.names().find(newName); name && !why) {
        why = occurrence->entity.kind == Kind::Parameter ? whyNotForParameter(document, occurrence->entity, *name)
                                                         : whyNotForDeclared(document, found, *name);
    }
    if (why) {
        return std::unexpected(*why);
    }
    TextEdits edits;
    for (const Occurrence &each : found) {
        if (each.isName) {
            edits.push_back({each.range, std::string(newName)});
        }
    }
    return edits;
}

}
