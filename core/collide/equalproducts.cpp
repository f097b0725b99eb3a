// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "equalproducts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr std::size_t mostPairs = 4'096;
constexpr std::size_t mostPairsInAll = 65'536;
constexpr std::size_t mostNodes = 1'024;
/// Exchanges far down hardly move a copy then.
constexpr double leastShrinking = 0.85;
/// What rounding may put two equal products apart, of the numbers that they are made of.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Pairs of sets of which the second may follow the first at once, or past levels that hold `#`.
std::set<std::pair<SetId, SetId>> neighbours(const FractalGraph &graph)
{
    const BoundLayout &layout = graph.layout();
    std::set<std::pair<SetId, SetId>> pairs;
    std::vector<BoundLayout::Node> waiting;
    std::vector<bool> isKnown;
    for (BoundLayout::Node node = 0; node < layout.nodeCount(); ++node) {
        for (const auto &[slot, next] : layout.steps(node)) {
            const SetId first = graph.levels().set(slot);
            isKnown.assign(layout.nodeCount(), false);
            waiting = {next};
            while (!waiting.empty()) {
                const BoundLayout::Node after = waiting.back();
                waiting.pop_back();
                for (const auto &[slotAfter, nextAfter] : layout.steps(after)) {
                    pairs.emplace(first, graph.levels().set(slotAfter));
                    if (graph.setAt(slotAfter).holdsIdentity && !isKnown[nextAfter]) {
                        isKnown[nextAfter] = true;
                        waiting.push_back(nextAfter);
                    }
                }
            }
        }
    }
    return pairs;
}

bool shrinks(const FractalGraph &graph, SetId set)
{
    return std::ranges::all_of(graph.facts(set), [](const MapFacts &facts) { return facts.norm <= leastShrinking; });
}

}

struct EqualProducts::Product {
    std::uint32_t first;
    std::uint32_t second;
    AffineMap map;
    /// Equal maps have nearly equal ones.
    double key;
    /// Of the translations that were added, and the norms.
    double moved;
    double norm;
    bool isLeftOut = false;

    [[nodiscard]] double apartFrom(const Product &other) const;
};

EqualProducts::EqualProducts(const FractalGraph &graph)
    : m_leftOut(graph.setCount())
{
    if (graph.setsShareMaps() || graph.layout().nodeCount() > mostNodes) {
        return;
    }
    for (SetId set = 0; set < graph.setCount(); ++set) {
        m_leftOut[set].resize(graph.set(set).maps.size());
    }
    std::size_t left = mostPairsInAll;
    for (const auto &[first, second] : neighbours(graph)) {
        const std::size_t pairs = graph.set(first).maps.size() * graph.set(second).maps.size();
        if (pairs <= std::min(mostPairs, left) && shrinks(graph, first) && shrinks(graph, second)) {
            left -= pairs;
            std::vector<Product> products = productsOf(graph, first, second);
            compare(products, first, second);
        }
    }
    m_isEmpty = std::ranges::all_of(
        m_leftOut, [](const auto &ofSet) { return std::ranges::all_of(ofSet, &std::vector<Pick>::empty); });
}

std::vector<EqualProducts::Product> EqualProducts::productsOf(const FractalGraph &graph, SetId first, SetId second)
{
    std::vector<Product> products;
    const auto &outer = graph.set(first).maps;
    const auto &inner = graph.set(second).maps;
    for (std::uint32_t i = 0; i < outer.size(); ++i) {
        for (std::uint32_t j = 0; j < inner.size(); ++j) {
            const AffineMap map = outer[i] * inner[j];
            const double norm = graph.facts(first)[i].norm;
            products.push_back({i, j, map, placeOf(map.translation),
                                glm::length(outer[i].translation) + norm * glm::length(inner[j].translation),
                                norm * graph.facts(second)[j].norm});
        }
    }
    return products;
}

/// How far apart two products are, of the numbers that they are made of.
double EqualProducts::Product::apartFrom(const Product &other) const
{
    const auto part = [](double apart, double of) { return apart > 0.0 ? apart / of : 0.0; };
    double apart = part(glm::length(map.translation - other.map.translation), moved);
    for (int column = 0; column < 3; ++column) {
        apart = std::max(apart, part(glm::length(map.linear[column] - other.map.linear[column]), norm));
    }
    return apart;
}

/// By their keys, each with the few before it that may be equal.
void EqualProducts::compare(std::vector<Product> &products, SetId first, SetId second)
{
    constexpr std::size_t mostCompared = 64;
    std::ranges::sort(products, {},
                      [](const Product &product) { return std::tuple(product.key, product.first, product.second); });
    for (std::size_t i = 0; i < products.size(); ++i) {
        Product &one = products[i];
        for (std::size_t j = i;
             j-- > 0 && i - j <= mostCompared && one.key - products[j].key <= rounding * one.moved;) {
            Product &other = products[j];
            const double apart = one.apartFrom(other);
            if (apart <= rounding) {
                const bool isLater = std::tie(one.first, one.second) > std::tie(other.first, other.second);
                (isLater ? one : other).isLeftOut = true;
                m_apart = std::max(m_apart, apart);
            }
        }
    }
    for (const Product &product : products) {
        if (product.isLeftOut) {
            m_leftOut[first][product.first].push_back({second, product.second});
        }
    }
}

void EqualProducts::leaveOut(std::span<const DescentStep> path, std::span<const DescentStep> children,
                             double *numbers) const
{
    if (path.empty()) {
        return;
    }
    for (const auto &[set, map] : leftOutAfter(path.back().set, path.back().map)) {
        const auto child =
            std::ranges::find_if(children, [&](const DescentStep &step) { return step.set == set && step.map == map; });
        if (child != children.end()) {
            numbers[child - children.begin()] = std::numeric_limits<double>::infinity();
        }
    }
}

bool EqualProducts::leavesOutNoMore(const DescentStep &after, const DescentStep &thanAfter) const
{
    const std::span<const Pick> others = leftOutAfter(thanAfter.set, thanAfter.map);
    return std::ranges::all_of(leftOutAfter(after.set, after.map),
                               [&](const Pick &pick) { return std::ranges::contains(others, pick); });
}

std::size_t EqualProducts::memoryUse() const
{
    std::size_t bytes = m_leftOut.capacity() * sizeof(m_leftOut.front());
    for (const auto &ofSet : m_leftOut) {
        bytes += ofSet.capacity() * sizeof(std::vector<Pick>);
        for (const std::vector<Pick> &picks : ofSet) {
            bytes += picks.capacity() * sizeof(Pick);
        }
    }
    return bytes;
}

}
