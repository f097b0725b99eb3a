// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "summary.h"

#include <algorithm>
#include <map>

#include "core/fractal/counts.h"
#include "core/fractal/dimension.h"

namespace romanesco {

namespace {

constexpr Position mostLevelSizes = 1'000;

std::optional<Summary::Iteration> singleIteration(const FractalGraph &graph)
{
    const LevelSequence &levels = graph.levels();
    const std::vector<LevelSequence::Repeat> &repeats = levels.repeats();
    const bool isSingle = repeats.size() == 2 && repeats[1].length() == levels.levelCount();
    if (!isSingle) {
        return std::nullopt;
    }
    std::uint64_t transforms = 1;
    for (LevelSequence::Slot slot = 0; slot < levels.slotCount(); ++slot) {
        if (__builtin_mul_overflow(transforms, graph.setAt(slot).size(), &transforms)) {
            return std::nullopt;
        }
    }
    return Summary::Iteration{transforms, repeats[1].count};
}

void widen(std::optional<Summary::Contraction> &known, const Summary::Contraction &more)
{
    known = known ? Summary::Contraction{std::min(known->least, more.least), std::max(known->greatest, more.greatest)}
                  : more;
}

}

Summary summarise(const Model &model)
{
    const FractalGraph &graph = model.graph;
    const LevelSequence &levels = graph.levels();
    Summary summary;
    summary.facesPerBase = model.mesh->faces.size();
    summary.levelCount = levels.levelCount();
    if (levels.levelCount() <= mostLevelSizes) {
        for (Position position = 0; position < levels.levelCount(); ++position) {
            summary.levelSizes.push_back(graph.setAt(levels.locate(position).slot).size());
        }
    }
    summary.iteration = singleIteration(graph);
    summary.instancesAsWritten = instancesAsWritten(graph);
    summary.instancesDistinct = instancesDistinct(graph);
    summary.facesAsWritten = summary.instancesAsWritten * Count(*summary.facesPerBase);

    for (LevelSequence::Slot slot = 0; slot < levels.slotCount(); ++slot) {
        for (const MapFacts &facts : graph.facts(levels.set(slot))) {
            widen(summary.contraction, {facts.norm, facts.norm});
        }
    }
    summary.isContracting = !summary.contraction || summary.contraction->greatest < 1.0;
    summary.similarityDimension = similarityDimension(graph);
    return summary;
}

Summary summarise(const Scene &scene)
{
    if (scene.items.size() == 1) {
        return summarise(*scene.items.front().model);
    }
    std::map<const Model *, Summary> models;
    Summary sum;
    sum.instancesDistinct = Count(0);
    for (const SceneItem &item : scene.items) {
        auto known = models.find(item.model.get());
        if (known == models.end()) {
            known = models.emplace(item.model.get(), summarise(*item.model)).first;
        }
        const Summary &one = known->second;
        sum.instancesAsWritten = sum.instancesAsWritten + one.instancesAsWritten;
        sum.facesAsWritten = sum.facesAsWritten + one.facesAsWritten;
        sum.instancesDistinct = sum.instancesDistinct && one.instancesDistinct
            ? std::optional(*sum.instancesDistinct + *one.instancesDistinct)
            : std::nullopt;
        sum.isContracting = sum.isContracting && one.isContracting;
        if (one.contraction) {
            widen(sum.contraction, *one.contraction);
        }
    }
    return sum;
}

}
