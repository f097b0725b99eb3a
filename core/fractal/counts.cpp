// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "counts.h"

#include <algorithm>
#include <map>

#include "statetable.h"

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;
using Vector = std::vector<Count>;
using Matrix = std::vector<Vector>;

constexpr std::size_t widestMatrix = 48;
constexpr Position levelsOneByOne = 100'000;
constexpr std::size_t mostStates = 100'000;
/// Sums and products, over all levels that are looked at one by one.
constexpr std::uint64_t mostTerms = 5'000'000;

/// Maps that occur in the same sets and so always come together.
struct Part {
    std::uint64_t size = 0;
};

class LinearCounter
{
public:
    explicit LinearCounter(const FractalGraph &graph)
        : m_graph(graph)
        , m_runs(graph.levels().repeats().size())
    {
        findParts();
    }

    /// Words over all levels; nothing where it would take too long.
    std::optional<Count> count()
    {
        Vector words(m_parts.size() + 1, Count(0));
        words[0] = Count(1);
        if (!apply(0, words)) {
            return std::nullopt;
        }
        return total(words);
    }

private:
    void findParts()
    {
        std::vector<std::vector<SetId>> setsOfClass(m_graph.mapClassCount());
        for (SetId id = 0; id < m_graph.setCount(); ++id) {
            if (m_graph.canonical(id) == id) {
                for (const std::uint32_t number : m_graph.mapClasses(id)) {
                    setsOfClass[number].push_back(id);
                }
            }
        }
        std::map<std::vector<SetId>, std::size_t> partOfSets;
        m_partsOfSet.resize(m_graph.setCount());
        for (const std::vector<SetId> &sets : setsOfClass) {
            const auto [known, isNew] = partOfSets.try_emplace(sets, m_parts.size());
            if (isNew) {
                m_parts.emplace_back();
                for (const SetId id : sets) {
                    m_partsOfSet[id].push_back(known->second);
                }
            }
            ++m_parts[known->second].size;
        }
    }

    Count total(const Vector &words) const
    {
        Count sum = words[0];
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            if (!words[i + 1].isZero()) {
                sum += words[i + 1] * Count(m_parts[i].size);
            }
        }
        return sum;
    }

    bool applyLevel(Slot slot, Vector &words)
    {
        m_terms += words.size();
        if (m_terms > mostTerms) {
            return false;
        }
        const SetId set = m_graph.levels().set(slot);
        Count after = total(words);
        if (!m_graph.set(set).holdsIdentity) {
            std::ranges::fill(words, Count(0));
        }
        for (const std::size_t part : m_partsOfSet[m_graph.canonical(set)]) {
            words[part + 1] = after;
        }
        return true;
    }

    /// One pass of a repeat, from its last level up.
    bool applyPass(const LevelSequence::Repeat &repeat, Vector &words)
    {
        Slot slot = repeat.endSlot;
        for (std::size_t i = repeat.inner.size(); i-- > 0;) {
            const LevelSequence::Repeat &inner = m_graph.levels().repeats()[repeat.inner[i]];
            for (; slot > inner.endSlot; --slot) {
                if (!applyLevel(slot - 1, words)) {
                    return false;
                }
            }
            if (!apply(repeat.inner[i], words)) {
                return false;
            }
            slot = inner.firstSlot;
        }
        for (; slot > repeat.firstSlot; --slot) {
            if (!applyLevel(slot - 1, words)) {
                return false;
            }
        }
        return true;
    }

    bool apply(std::uint32_t index, Vector &words)
    {
        const LevelSequence::Repeat &repeat = m_graph.levels().repeats()[index];
        if (index == 0 || repeat.length() <= levelsOneByOne) {
            for (std::uint64_t i = 0; i < repeat.count; ++i) {
                if (!applyPass(repeat, words)) {
                    return false;
                }
            }
            return true;
        }
        if (words.size() > widestMatrix) {
            return false;
        }
        // Made once: repeats nest, and each pass of an outer one comes here again.
        Matrix &run = m_runs[index];
        if (run.empty()) {
            const std::optional<Matrix> pass = passMatrix(index);
            if (!pass) {
                return false;
            }
            run = power(*pass, repeat.count);
        }
        words = applied(run, words);
        return true;
    }

    /// Column i is what a pass makes of the i-th unit vector.
    std::optional<Matrix> passMatrix(std::uint32_t index)
    {
        const std::size_t size = m_parts.size() + 1;
        Matrix columns;
        for (std::size_t i = 0; i < size; ++i) {
            Vector unit(size, Count(0));
            unit[i] = Count(1);
            if (!applyPass(m_graph.levels().repeats()[index], unit)) {
                return std::nullopt;
            }
            columns.push_back(std::move(unit));
        }
        return columns;
    }

    static Vector applied(const Matrix &columns, const Vector &words)
    {
        Vector result(words.size(), Count(0));
        for (std::size_t i = 0; i < words.size(); ++i) {
            for (std::size_t j = 0; !words[i].isZero() && j < words.size(); ++j) {
                if (!columns[i][j].isZero()) {
                    result[j] += columns[i][j] * words[i];
                }
            }
        }
        return result;
    }

    static Matrix power(Matrix base, std::uint64_t exponent)
    {
        Matrix result(base.size(), Vector(base.size(), Count(0)));
        for (std::size_t i = 0; i < base.size(); ++i) {
            result[i][i] = Count(1);
        }
        const auto product = [](const Matrix &outer, const Matrix &inner) {
            Matrix columns;
            for (const Vector &column : inner) {
                columns.push_back(applied(outer, column));
            }
            return columns;
        };
        for (; exponent != 0; exponent >>= 1) {
            if (exponent & 1) {
                result = product(base, result);
            }
            if (exponent > 1) {
                base = product(base, base);
            }
        }
        return result;
    }

    const FractalGraph &m_graph;
    std::vector<Part> m_parts;
    std::vector<std::vector<std::size_t>> m_partsOfSet;
    /// By repeat: what its whole run does, where that was needed.
    std::vector<Matrix> m_runs;
    std::uint64_t m_terms = 0;
};

/// Whether some map is in a set with `#` and in one without. Then what follows it need not be nested, and words are
/// counted over the states themselves.
bool needsStates(const FractalGraph &graph)
{
    std::vector<int> seenIn(graph.mapClassCount(), 0);
    for (SetId id = 0; id < graph.setCount(); ++id) {
        for (const std::uint32_t number : graph.mapClasses(id)) {
            seenIn[number] |= graph.set(id).holdsIdentity ? 1 : 2;
        }
    }
    return std::ranges::find(seenIn, 3) != seenIn.end();
}

/// Words below each state, children before their parents, without recursion.
std::optional<Count> countOverStates(const FractalGraph &graph)
{
    StateTable table(graph);
    std::vector<std::optional<Count>> words;
    std::vector<StateId> open{table.root()};
    while (!open.empty()) {
        const StateId id = open.back();
        const Expansion &expansion = table.expansion(id);
        words.resize(table.stateCount());
        if (table.stateCount() > mostStates) {
            return std::nullopt;
        }
        const std::size_t before = open.size();
        Count sum(expansion.hasLeaf ? 1 : 0);
        for (const ChildRange &range : expansion.ranges) {
            if (!words[range.next]) {
                open.push_back(range.next);
            } else {
                sum += *words[range.next] * Count(range.endMap - range.firstMap);
            }
        }
        if (open.size() == before) {
            words[id] = sum;
            open.pop_back();
        }
    }
    return words[table.root()];
}

}

Count instancesAsWritten(const FractalGraph &graph)
{
    const std::vector<LevelSequence::Repeat> &repeats = graph.levels().repeats();
    std::vector<Count> passes(repeats.size(), Count(1));
    for (std::size_t i = repeats.size(); i-- > 0;) {
        Slot slot = repeats[i].firstSlot;
        const auto multiplyTo = [&](Slot end) {
            for (; slot < end; ++slot) {
                passes[i] *= Count(graph.setAt(slot).size());
            }
        };
        for (const std::uint32_t inner : repeats[i].inner) {
            multiplyTo(repeats[inner].firstSlot);
            passes[i] *= power(passes[inner], repeats[inner].count);
            slot = repeats[inner].endSlot;
        }
        multiplyTo(repeats[i].endSlot);
    }
    return passes[0];
}

std::optional<Count> instancesDistinct(const FractalGraph &graph)
{
    return needsStates(graph) ? countOverStates(graph) : LinearCounter(graph).count();
}

}
