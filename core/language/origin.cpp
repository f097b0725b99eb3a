// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "origin.h"

#include <algorithm>
#include <format>

namespace romanesco {

namespace {

/// `z[3]` in the third pass of z's iteration; elsewhere the name alone.
std::string placeName(const FdoDocument &document, const ObjectForest::Origin &origin)
{
    const ObjectNode &node = document.model.forest[origin.node];
    std::string name = node.name == NameTable::nameless ? "<$>" : std::string(document.syntax.names()[node.name]);
    if (!origin.passes.empty() && origin.passes.back().recursive == origin.node) {
        name += std::format("[{}]", origin.passes.back().pass + 1);
    }
    return name;
}

/// Of what the depth is the number; none where there is no depth.
std::uint32_t countedRecursive(const FdoModel &model)
{
    const std::optional<std::uint32_t> line = model.depthLine();
    for (std::uint32_t i = 0; line && i < model.forest.size(); ++i) {
        if (model.forest[i].line == *line && model.forest[i].repeated != ObjectNode::none) {
            return model.forest[i].repeated;
        }
    }
    return ObjectNode::none;
}

}

std::vector<OriginStep> origin(const FdoDocument &document, const FractalDescription &description,
                               const Address &address)
{
    std::vector<OriginStep> steps;
    const FdoSyntax &syntax = document.syntax;
    const FdoModel &model = document.model;
    const std::uint32_t counted = countedRecursive(model);
    for (const Pick &pick : address) {
        if (pick.position >= description.levels.levelCount()) {
            break;
        }
        const ObjectForest::Origin place = model.forest.origin(model.result, pick.position);
        const TransformSet &set = description.sets[place.set];
        if (pick.map >= set.uses.size()) {
            break;
        }
        const SourceRange use = set.uses[pick.map];
        const std::uint32_t line = model.forest[place.node].line;
        const auto &node = std::get<ObjectDeclaration>(syntax.line(line).declaration);
        steps.push_back({placeName(document, place) + ' ' + syntax.text().substr(use.begin, use.length()), use,
                         syntax.range(line, node.name.range)});
        if (!place.passes.empty() && place.passes.front().recursive == counted) {
            steps.back().pass = place.passes.front().pass + 1;
        }
    }
    return steps;
}

std::optional<UseOfSet> useAt(const FdoDocument &document, const FractalDescription &description, std::size_t offset)
{
    const FdoSyntax &syntax = document.syntax;
    const FdoModel &model = document.model;
    if (offset > syntax.text().size() || syntax.lineCount() == 0) {
        return std::nullopt;
    }
    const std::size_t line = syntax.map().lineAt(offset);
    const auto inLine = static_cast<std::uint32_t>(line);
    auto place = std::ranges::lower_bound(model.sets, inLine, {}, &SetPlace::line);
    for (; place != model.sets.end() && place->line == inLine; ++place) {
        const auto &node = std::get<ObjectDeclaration>(syntax.line(line).declaration);
        for (const TransformationUse &use : node.value.sets[place->index].uses) {
            if (!syntax.range(line, use.range).touches(offset)) {
                continue;
            }
            const auto id = static_cast<SetId>(place - model.sets.begin());
            const std::optional<TransformParts> parts = model.parts(use, line);
            if (id >= description.sets.size() || (!parts && !use.isIdentity())) {
                return std::nullopt;
            }
            const TransformSet &set = description.sets[id];
            const AffineMap map =
                use.isIdentity() ? AffineMap{} : mapFromParts(parts->position, parts->rotation, parts->scale);
            const auto found = std::ranges::find(set.maps, map);
            if (found == set.maps.end()) {
                return set.holdsIdentity && map == AffineMap{} ? std::optional(UseOfSet{id, std::nullopt})
                                                               : std::nullopt;
            }
            return UseOfSet{id, static_cast<std::uint32_t>(found - set.maps.begin())};
        }
    }
    return std::nullopt;
}

}
