// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "summary.h"

#include <algorithm>

#include "core/fractal/counts.h"

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

}

Summary summarise(const Scene &scene)
{
    const FractalGraph &graph = scene.graph;
    const LevelSequence &levels = graph.levels();
    Summary summary;
    summary.facesPerBase = scene.mesh->faces.size();
    summary.levelCount = levels.levelCount();
    if (summary.levelCount <= mostLevelSizes) {
        for (Position position = 0; position < summary.levelCount; ++position) {
            summary.levelSizes.push_back(graph.setAt(levels.locate(position).slot).size());
        }
    }
    summary.iteration = singleIteration(graph);
    summary.instancesAsWritten = instancesAsWritten(graph);
    summary.instancesDistinct = instancesDistinct(graph);
    summary.facesAsWritten = summary.instancesAsWritten * Count(summary.facesPerBase);

    for (LevelSequence::Slot slot = 0; slot < levels.slotCount(); ++slot) {
        for (const double norm : graph.norms(levels.set(slot))) {
            const Summary::Contraction known = summary.contraction.value_or(Summary::Contraction{norm, norm});
            summary.contraction = {std::min(known.least, norm), std::max(known.greatest, norm)};
        }
    }
    summary.isContracting = !summary.contraction || summary.contraction->greatest < 1.0;
    return summary;
}

}
