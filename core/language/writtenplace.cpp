// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "writtenplace.h"

#include <algorithm>
#include <variant>

#include "core/text/lexer.h"
#include "occurrences.h"

namespace romanesco {

namespace {

constexpr int position = 0;
constexpr int scale = 2;

WrittenNumber plainNumber(double value)
{
    WrittenNumber number;
    number.value = value;
    return number;
}

/// Nothing where three numbers are not there.
std::optional<WrittenVector> vectorOf(const std::string &text, const std::vector<SourceRange> &ranges)
{
    if (ranges.size() != 3) {
        return std::nullopt;
    }
    WrittenVector vector;
    vector.range = joined(ranges[0], ranges[2]);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<WrittenNumber> number = writtenNumber(text, ranges[i]);
        if (!number) {
            return std::nullopt;
        }
        vector.numbers[i] = *number;
        vector.words[i] = text.substr(ranges[i].begin, ranges[i].length());
        if (i > 0) {
            vector.between[i] = text.substr(ranges[i - 1].end, ranges[i].begin - ranges[i - 1].end);
        }
    }
    return vector;
}

/// Of a declaration.
std::optional<WrittenVector> declaredVector(const FdoDocument &document, std::uint32_t index)
{
    const VectorEntry &entry = document.model.vectors[index];
    const FdoSyntax &syntax = document.syntax;
    const SourceRange line = syntax.map().line(entry.line);
    LineLexer lexer(std::string_view(syntax.text()).substr(line.begin, line.length()), line.begin);
    std::vector<SourceRange> ranges;
    lexer.take(); // the name
    for (Token token = lexer.take(); !token.is(TokenKind::EndOfLine) && ranges.size() < 3; token = lexer.take()) {
        if (token.is(TokenKind::Number)) {
            ranges.push_back(token.range);
        }
    }
    return entry.isBad ? std::nullopt : vectorOf(syntax.text(), ranges);
}

/// In how many uses of transformations a vector says something; those that have it from their declaration count each.
std::size_t usesOf(const FdoDocument &document, std::uint32_t index)
{
    std::size_t count = 0;
    const Entity vector{Entity::Kind::Vector, document.model.vectors[index].line, index, {}};
    for (const Occurrence &occurrence : occurrences(document, vector)) {
        if (occurrence.isDeclaration) {
            continue;
        }
        const std::size_t line = document.syntax.map().lineAt(occurrence.range.begin);
        const auto &declaration = document.syntax.line(line).declaration;
        if (!std::holds_alternative<TransformationDeclaration>(declaration)) {
            ++count;
            continue;
        }
        const SourceRange name =
            document.syntax.range(line, std::get<TransformationDeclaration>(declaration).name.range);
        const std::optional<Occurrence> transformation = occurrenceAt(document, name.begin);
        for (const Occurrence &use :
             transformation ? occurrences(document, transformation->entity) : std::vector<Occurrence>()) {
            count += use.isDeclaration ? 0 : 1;
        }
    }
    return count;
}

/// The vector that says a part of a use.
std::optional<std::uint32_t> vectorOfPart(const FdoDocument &document, const TransformationUse &use, std::size_t line,
                                          int part)
{
    const Symbol *symbol = document.model.find(use.name.name, line);
    if (!symbol || symbol->kind != SymbolKind::Transformation) {
        return std::nullopt;
    }
    const PartSource &source = document.model.transformations[symbol->index].parts[static_cast<std::size_t>(part)];
    if (source.kind == PartSource::Kind::Vector) {
        return source.index;
    }
    const bool isArgument = source.kind == PartSource::Kind::Parameter && source.index < use.arguments.size();
    return isArgument ? document.model.vector(use.arguments[source.index], line) : std::nullopt;
}

/// A `#` that becomes a vector.
WrittenVector openedVector(SourceRange range, double value, const std::string &before, const std::string &after)
{
    WrittenVector vector;
    vector.range = range;
    vector.numbers.fill(plainNumber(value));
    vector.words.fill(value == 0.0 ? "0" : "1");
    vector.between = {before, ", ", ", ", after};
    return vector;
}

}

glm::dvec3 WrittenVector::value() const
{
    return {numbers[0].value, numbers[1].value, numbers[2].value};
}

std::string WrittenVector::with(const glm::dvec3 &value, int leastDecimals) const
{
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
        WrittenNumber number = numbers[i];
        const double wanted = value[static_cast<int>(i)];
        number.decimals = std::max(number.decimals, leastDecimals);
        text += between[i] + (wanted == number.value ? words[i] : withValue(number, wanted).text);
    }
    return text + between[3];
}

std::optional<WrittenPlace> placeOfUse(const FdoDocument &document, std::size_t offset)
{
    const FdoSyntax &syntax = document.syntax;
    if (offset >= syntax.text().size() || syntax.lineCount() == 0) {
        return std::nullopt;
    }
    const std::size_t line = syntax.map().lineAt(offset);
    const auto *node = std::get_if<ObjectDeclaration>(&syntax.line(line).declaration);
    for (const SetExpression &set : node ? node->value.sets : std::vector<SetExpression>()) {
        const auto use = std::ranges::find_if(
            set.uses, [&](const TransformationUse &each) { return syntax.range(line, each.range).begin == offset; });
        if (use == set.uses.end()) {
            continue;
        }
        const std::optional<TransformParts> parts = document.model.parts(*use, line);
        if (!parts) {
            return std::nullopt;
        }
        WrittenPlace place{*parts, {}};
        for (int part = position; part <= scale; ++part) {
            if (const auto index = vectorOfPart(document, *use, line, part)) {
                auto &vector = place.vectors[static_cast<std::size_t>(part)];
                vector = declaredVector(document, *index);
                if (vector) {
                    vector->uses = usesOf(document, *index);
                }
            }
        }
        return place;
    }
    return std::nullopt;
}

std::optional<WrittenPlace> placeOfItem(const SdoSyntax &scene, std::size_t item)
{
    for (std::size_t i = 0; i < scene.lineCount(); ++i) {
        const PlacedFile *file = scene.line(i).isBad ? nullptr : scene.line(i).file();
        if (!file || item-- > 0) {
            continue;
        }
        const TransformExpression &transform = file->transform;
        const std::array<const VectorExpression *, 3> written{&transform.position, &transform.rotation,
                                                              &transform.scale};
        WrittenPlace place{{transform.position.value, transform.rotation.value, transform.scale.value}, {}};
        for (std::size_t part = 0; part < 3; ++part) {
            const VectorExpression &vector = *written[part];
            const double identity = part == scale ? 1.0 : 0.0;
            if (transform.isIdentity) {
                const std::array<std::string, 3> before{"((", "(#, (", "(#, #, ("};
                const std::array<std::string, 3> after{"), #, #)", "), #)", "))"};
                place.vectors[part] =
                    openedVector(scene.range(i, transform.range), identity, before[part], after[part]);
            } else if (vector.isIdentity) {
                place.vectors[part] = openedVector(scene.range(i, vector.range), identity, "(", ")");
            } else {
                std::vector<SourceRange> ranges;
                ranges.reserve(3);
                for (const LineRange &number : vector.numbers) {
                    ranges.push_back(scene.range(i, number));
                }
                place.vectors[part] = vectorOf(scene.text(), ranges);
            }
        }
        return place;
    }
    return std::nullopt;
}

}
