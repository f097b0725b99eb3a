// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ballstep.h"

namespace romanesco {

/// Balls that may touch one another within a step, by their numbers.
struct BallPair {
    std::size_t one = 0;
    /// Above `one`.
    std::size_t other = 0;

    auto operator<=>(const BallPair &) const = default;
};

/// How far from its centre a ball may reach within a time.
[[nodiscard]] double reachOf(const BallState &ball, const Laws &laws, double time);

/// All pairs whose balls can touch, as far as they reach, in order: of those that are counted from one place, of those of which one is awake or both
/// lie in a pile. Cost: a look into 27 cells of a grid for each ball, and for each size of cells above its own, by powers of two.
[[nodiscard]] std::vector<BallPair> nearPairs(std::span<const BallState> balls, std::span<const double> reaches);

/// Balls that are tied by pairs.
struct BallIsland {
    std::vector<std::size_t> balls;
    std::vector<BallPair> pairs;
};

/// All islands of which one ball is awake, in order of their first balls.
[[nodiscard]] std::vector<BallIsland> islandsOf(std::span<const BallState> balls, std::span<const BallPair> pairs);

}
