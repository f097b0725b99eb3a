// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/count.h"
#include "scene.h"

namespace romanesco {

/// The numbers that `romanesco info` and the status bar show of a scene: those of its only item, or the sums of several.
struct Summary {
    /// Nothing where there are several items, or none: they have no base mesh and no levels in common.
    std::optional<std::uint64_t> facesPerBase;
    std::optional<Position> levelCount;
    /// The sizes of all levels, outermost first, `#` counted; empty beyond 1,000 levels, or where there is no count.
    std::vector<std::uint64_t> levelSizes;

    /// Where the fractal is one iteration repeated round a bare mesh: its levels' sizes multiplied, and the depth.
    struct Iteration {
        std::uint64_t transforms;
        std::uint64_t depth;
    };
    std::optional<Iteration> iteration;

    Count instancesAsWritten;
    /// Nothing where it would take too long (see instancesDistinct()).
    std::optional<Count> instancesDistinct;
    Count facesAsWritten;

    /// Whether every map but the identity has an operator norm below 1.
    bool isContracting = true;
    /// The least and greatest operator norm of the maps, the identity left out; nothing where there is no map.
    struct Contraction {
        double least;
        double greatest;
    };
    std::optional<Contraction> contraction;

    /// See similarityDimension(); nothing where there are several items, or none.
    std::optional<double> similarityDimension;
};

[[nodiscard]] Summary summarise(const Model &model);

/// Items that share a model are counted each; every model is looked at once.
[[nodiscard]] Summary summarise(const Scene &scene);

}
