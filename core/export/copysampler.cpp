// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "copysampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;
using Repeat = LevelSequence::Repeat;

constexpr Position mostLevels = 1'000;
constexpr std::size_t mostStates = 10'000;
constexpr std::size_t mostBytes = std::size_t{64} << 20;

/// Levels with the passes of each repeat cut to a few where there are many.
class ShortenedLevels
{
public:
    explicit ShortenedLevels(const LevelSequence &levels)
        : m_levels(levels)
    {
        write(0);
    }

    LevelSequence take() { return std::move(m_builder).build(); }

private:
    /// Repeats nest at most 64 deep.
    void write(std::uint32_t index)
    {
        const Repeat &repeat = m_levels.repeats()[index];
        Slot slot = repeat.firstSlot;
        const auto addTo = [&](Slot end) {
            for (; slot < end; ++slot) {
                m_builder.addLevel(m_levels.set(slot));
            }
        };
        for (const std::uint32_t inner : repeat.inner) {
            addTo(m_levels.repeats()[inner].firstSlot);
            m_builder.beginRepeat(passes(inner));
            write(inner);
            m_builder.endRepeat();
            slot = m_levels.repeats()[inner].endSlot;
        }
        addTo(repeat.endSlot);
    }

    /// Those side by side share the levels that there may be, and those inside one another their logarithm.
    [[nodiscard]] std::uint64_t passes(std::uint32_t index) const
    {
        const Repeat &repeat = m_levels.repeats()[index];
        const double slots = repeat.endSlot - repeat.firstSlot;
        const double share = static_cast<double>(mostLevels) * slots / m_levels.slotCount();
        const double passes = std::pow(std::max(share / slots, 1.0), 1.0 / nesting(index));
        return std::min(repeat.count, static_cast<std::uint64_t>(passes));
    }

    /// How deep repeats nest from the outermost round this one to its innermost.
    [[nodiscard]] int nesting(std::uint32_t index) const
    {
        int depth = 1;
        for (std::uint32_t outer = m_levels.repeats()[index].parent; outer != 0;
             outer = m_levels.repeats()[outer].parent) {
            ++depth;
        }
        return depth + heightBelow(index);
    }

    [[nodiscard]] int heightBelow(std::uint32_t index) const
    {
        int height = 0;
        for (const std::uint32_t inner : m_levels.repeats()[index].inner) {
            height = std::max(height, 1 + heightBelow(inner));
        }
        return height;
    }

    const LevelSequence &m_levels;
    LevelSequence::Builder m_builder;
};

FractalGraph shortened(const FractalGraph &graph)
{
    if (graph.levels().levelCount() <= mostLevels) {
        return graph;
    }
    FractalDescription description;
    for (SetId set = 0; set < graph.setCount(); ++set) {
        description.sets.push_back(graph.set(set));
    }
    description.levels = ShortenedLevels(graph.levels()).take();
    // Fewer levels may grow beyond all numbers where more of them shrank again.
    return FractalGraph::build(description, graph.base()).value_or(FractalGraph::ofMesh(graph.base()));
}

/// log(exp(a) + exp(b)).
double sumOfLogarithms(double a, double b)
{
    const double larger = std::max(a, b);
    return std::isinf(larger) ? larger : larger + std::log1p(std::exp(std::min(a, b) - larger));
}

}

CopySampler::CopySampler(const FractalGraph &graph)
    : m_graph(shortened(graph))
    , m_table(m_graph)
{
    weigh();
}

/// Children before their parents, without recursion.
void CopySampler::weigh()
{
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<StateId> open{m_table.root()};
    while (!open.empty()) {
        const StateId id = open.back();
        const Expansion &expansion = m_table.expansion(id);
        m_weights.resize(m_table.stateCount(), unknown);
        if (m_table.stateCount() > mostStates || m_table.memoryUse() > mostBytes) {
            m_weights.clear();
            return;
        }
        const std::size_t before = open.size();
        for (const ChildRange &range : expansion.ranges) {
            if (std::isnan(m_weights[range.next])) {
                open.push_back(range.next);
            }
        }
        if (open.size() == before) {
            m_weights[id] = expansion.hasLeaf ? 0.0 : -std::numeric_limits<double>::infinity();
            for (const ChildRange &range : expansion.ranges) {
                m_weights[id] = sumOfLogarithms(m_weights[id], weightOf(range));
            }
            open.pop_back();
        }
    }
}

double CopySampler::weightBelow(StateId state) const
{
    return m_weights.empty() ? 0.0 : m_weights[state];
}

double CopySampler::weightOf(const ChildRange &range) const
{
    return std::log(range.endMap - range.firstMap) + weightBelow(range.next);
}

/// A child's range; null for the copy that stands in the state itself.
const ChildRange *CopySampler::draw(StateId state, std::mt19937_64 &random)
{
    const Expansion &expansion = m_table.expansion(state);
    m_work += 1 + expansion.ranges.size();
    double largest = 0.0;
    for (const ChildRange &range : expansion.ranges) {
        largest = std::max(largest, weightOf(range));
    }
    m_shares.clear();
    double sum = expansion.hasLeaf ? std::exp(-largest) : 0.0;
    for (const ChildRange &range : expansion.ranges) {
        m_shares.push_back(std::exp(weightOf(range) - largest));
        sum += m_shares.back();
    }
    double at = std::uniform_real_distribution<double>(0.0, sum)(random);
    for (std::size_t i = 0; i < m_shares.size(); ++i) {
        at -= m_shares[i];
        if (at <= 0.0) {
            return &expansion.ranges[i];
        }
    }
    return expansion.hasLeaf || expansion.ranges.empty() ? nullptr : &expansion.ranges.back();
}

AffineMap CopySampler::sample(std::mt19937_64 &random)
{
    if (m_weights.empty() && m_table.memoryUse() > mostBytes) {
        m_table.forget();
    }
    AffineMap map;
    StateId state = m_table.root();
    while (m_table.memoryUse() <= 2 * mostBytes) {
        const ChildRange *range = draw(state, random);
        if (!range) {
            break;
        }
        const auto size = range->endMap - range->firstMap;
        const auto pick = range->firstMap + static_cast<std::uint32_t>(random() % size);
        map = map * m_graph.set(range->set).maps[pick];
        state = range->next;
    }
    return map;
}

}
