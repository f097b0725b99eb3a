// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <random>
#include <vector>

#include "core/fractal/statetable.h"

namespace romanesco {

/// Draws copies of a fractal at random, each as likely as any other, without listing them. Beyond a thousand levels repeats
/// are cut short: what lies deeper moves a copy by less than shows in its numbers. Where there are too many states to
/// count what is below each, branches are drawn as if all held equally many. One thread uses it.
class CopySampler
{
public:
    /// Cost: that of visiting the states that are left, up to 10^4 or 64 MB.
    explicit CopySampler(const FractalGraph &graph);
    CopySampler(const CopySampler &) = delete;
    CopySampler &operator=(const CopySampler &) = delete;

    /// Where the copy stands in the model. Cost: a step for each of its levels.
    [[nodiscard]] AffineMap sample(std::mt19937_64 &random);

    /// Branches looked at so far, some nanoseconds each.
    [[nodiscard]] std::uint64_t work() const { return m_work; }

private:
    void weigh();
    [[nodiscard]] double weightBelow(StateId state) const;
    [[nodiscard]] double weightOf(const ChildRange &range) const;
    [[nodiscard]] const ChildRange *draw(StateId state, std::mt19937_64 &random);

    /// A copy of the graph, or one of fewer levels.
    FractalGraph m_graph;
    StateTable m_table;
    /// By state, the natural logarithm of the words below it; empty where there are too many states.
    std::vector<double> m_weights;
    std::vector<double> m_shares;
    std::uint64_t m_work = 0;
};

}
