// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "dimension.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace romanesco {

namespace {

using Slot = LevelSequence::Slot;

constexpr Position mostLevels = 100'000;

/// The slots of one pass, the last level first; empty unless passes of one iteration make up the whole.
std::vector<Slot> slotsOfPass(const LevelSequence &levels)
{
    std::vector<Slot> slots;
    const bool isOne = levels.repeats().size() > 1 && levels.repeats()[1].length() == levels.levelCount();
    if (isOne && levels.repeats()[1].passLength <= mostLevels) {
        for (Position position = levels.repeats()[1].passLength; position-- > 0;) {
            slots.push_back(levels.locate(position).slot);
        }
    }
    return slots;
}

/// Adds up powers of the scales of maps.
class PowerSum
{
public:
    void add(const MapFacts &facts) { m_logScales.push_back(std::log(facts.norm)); }
    [[nodiscard]] bool isEmpty() const { return m_logScales.empty(); }

    [[nodiscard]] double operator()(double exponent) const
    {
        double sum = 0.0;
        for (const double logScale : m_logScales) {
            sum += std::exp(exponent * logScale);
        }
        return sum;
    }

private:
    std::vector<double> m_logScales;
};

/// The scales of all that one pass makes, to the power of D and added up, where some level is passed over by no word.
/// As words are counted: from the last level up, for each set what may follow its first place; here round the cycle,
/// from that level to the same of the pass before.
class PassSum
{
public:
    /// The first of the slots holds no `#`.
    PassSum(const FractalGraph &graph, std::vector<Slot> slots)
        : m_graph(graph)
        , m_slots(std::move(slots))
        , m_sumOfSet(graph.setCount())
    {
        for (const Slot slot : m_slots) {
            const SetId set = setAt(slot);
            if (m_sumOfSet[set].isEmpty()) {
                std::ranges::for_each(graph.facts(set), [&](const MapFacts &facts) { m_sumOfSet[set].add(facts); });
            }
        }
    }

    [[nodiscard]] double logarithm(double dimension) const
    {
        std::vector<double> sums;
        sums.reserve(m_sumOfSet.size());
        for (const PowerSum &sum : m_sumOfSet) {
            sums.push_back(sum(dimension));
        }
        const SetId first = setAt(m_slots.front());
        std::vector<double> following(sums.size(), 0.0);
        following[first] = 1.0;
        double total = sums[first];
        double logFactor = 0.0;
        for (std::size_t i = 1; i <= m_slots.size(); ++i) {
            if (total == 0.0) {
                return -std::numeric_limits<double>::infinity();
            }
            if (total > 1e100 || total < 1e-100) {
                logFactor += std::log(total);
                std::ranges::for_each(following, [&](double &value) { value /= total; });
                total = 1.0;
            }
            const Slot slot = m_slots[i % m_slots.size()];
            const SetId set = setAt(slot);
            if (m_graph.setAt(slot).holdsIdentity) {
                const double more = total - following[set];
                following[set] = total;
                total += sums[set] * more;
            } else {
                std::ranges::fill(following, 0.0);
                following[set] = total;
                total *= sums[set];
            }
        }
        return std::log(following[first]) + logFactor;
    }

private:
    [[nodiscard]] SetId setAt(Slot slot) const { return m_graph.canonical(m_graph.levels().set(slot)); }

    const FractalGraph &m_graph;
    std::vector<Slot> m_slots;
    std::vector<PowerSum> m_sumOfSet;
};

/// The maps of all slots, each once.
PowerSum sumOfMaps(const FractalGraph &graph, const std::vector<Slot> &slots)
{
    PowerSum sum;
    std::vector<bool> isAdded(graph.mapClassCount());
    for (const Slot slot : slots) {
        const SetId set = graph.levels().set(slot);
        for (std::size_t i = 0; i < graph.facts(set).size(); ++i) {
            if (!isAdded[graph.mapClasses(set)[i]]) {
                isAdded[graph.mapClasses(set)[i]] = true;
                sum.add(graph.facts(set)[i]);
            }
        }
    }
    return sum;
}

/// Where a function that is convex and falls passes through 0, if that is at 0 or above: secants from the left do not
/// overshoot.
template<typename Function>
std::optional<double> rootOf(const Function &function)
{
    double before = 0.0;
    double valueBefore = function(before);
    if (!(valueBefore > 0.0)) {
        return valueBefore == 0.0 ? std::optional(0.0) : std::nullopt;
    }
    double at = 1.0;
    double value = function(at);
    while (value <= 0.0) {
        at /= 2.0;
        value = function(at);
    }
    constexpr int mostSteps = 200;
    for (int step = 0; step < mostSteps && value > 0.0 && value < valueBefore; ++step) {
        const double next = at + value * (at - before) / (valueBefore - value);
        before = std::exchange(at, next);
        valueBefore = std::exchange(value, function(next));
    }
    return at;
}

}

std::optional<double> similarityDimension(const FractalGraph &graph)
{
    std::vector<Slot> slots = slotsOfPass(graph.levels());
    const bool contractsAlike = std::ranges::all_of(slots, [&](Slot slot) {
        return std::ranges::all_of(graph.facts(graph.levels().set(slot)),
                                   [](const MapFacts &facts) { return facts.isSimilarity && facts.norm < 1.0; });
    });
    if (slots.empty() || !contractsAlike) {
        return std::nullopt;
    }
    const auto holdsIdentity = [&](Slot slot) { return graph.setAt(slot).holdsIdentity; };
    const auto fixed = std::ranges::find_if_not(slots, holdsIdentity);
    if (fixed == slots.end()) { // every sequence of maps is a word at some depth
        return rootOf([sum = sumOfMaps(graph, slots)](double dimension) { return std::log(sum(dimension)); });
    }
    if (graph.setsShareMaps() && std::ranges::any_of(slots, holdsIdentity)) {
        return std::nullopt;
    }
    std::ranges::rotate(slots, fixed);
    return rootOf([sum = PassSum(graph, std::move(slots))](double dimension) { return sum.logarithm(dimension); });
}

}
