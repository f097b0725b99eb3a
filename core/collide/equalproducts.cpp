// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "equalproducts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr std::size_t mostPairs = 4'096;
/// Exchanges far down hardly move a copy then.
constexpr double leastShrinking = 0.85;
/// What rounding may put two equal products apart, of the numbers that they are made of.
constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();

/// Bounds how far apart two maps place a point that is no farther from the origin than the reach.
double apart(const AffineMap &a, const AffineMap &b, double reach)
{
    double apart = glm::length(a.translation - b.translation);
    for (int column = 0; column < 3; ++column) {
        apart += glm::length(a.linear[column] - b.linear[column]) * reach;
    }
    return apart;
}

double farthestOf(const BoxBounds &boxes)
{
    double farthest = 0.0;
    for (const Box &box : boxes.ofNodes()) {
        if (!box.isEmpty()) {
            farthest = std::max(farthest, glm::length(glm::max(glm::abs(box.least), glm::abs(box.greatest))));
        }
    }
    return farthest;
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
};

EqualProducts::EqualProducts(const FractalGraph &graph, const BoxBounds &boxes)
    : m_leftOut(graph.setCount())
{
    const double reach = farthestOf(boxes);
    if (graph.setsShareMaps() || !std::isfinite(reach)) {
        return;
    }
    for (SetId first = 0; first < graph.setCount(); ++first) {
        m_leftOut[first].resize(graph.set(first).maps.size());
        for (SetId second = 0; second < graph.setCount(); ++second) {
            const std::size_t pairs = graph.set(first).maps.size() * graph.set(second).maps.size();
            if (pairs > 0 && pairs <= mostPairs && shrinks(graph, first) && shrinks(graph, second)) {
                std::vector<Product> products = productsOf(graph, first, second);
                compare(products, first, second, reach);
            }
        }
    }
    m_isEmpty = std::ranges::all_of(
        m_leftOut, [](const auto &ofSet) { return std::ranges::all_of(ofSet, &std::vector<Pick>::empty); });
}

std::vector<EqualProducts::Product> EqualProducts::productsOf(const FractalGraph &graph, SetId first, SetId second)
{
    // along this no two maps of a text are likely to be alike
    const glm::dvec3 along{0.618, 0.285, 0.733};
    std::vector<Product> products;
    const auto &outer = graph.set(first).maps;
    const auto &inner = graph.set(second).maps;
    for (std::uint32_t i = 0; i < outer.size(); ++i) {
        for (std::uint32_t j = 0; j < inner.size(); ++j) {
            const AffineMap map = outer[i] * inner[j];
            const double norm = graph.facts(first)[i].norm;
            products.push_back({i, j, map, glm::dot(along, map.translation),
                                glm::length(outer[i].translation) + norm * glm::length(inner[j].translation),
                                norm * graph.facts(second)[j].norm});
        }
    }
    return products;
}

/// By their keys, each with the few before it that may be equal.
void EqualProducts::compare(std::vector<Product> &products, SetId first, SetId second, double reach)
{
    constexpr std::size_t mostCompared = 64;
    std::ranges::sort(products, {},
                      [](const Product &product) { return std::tuple(product.key, product.first, product.second); });
    double size = 0.0;
    for (const Product &product : products) {
        size = std::max(size, product.moved + product.norm * reach);
    }
    for (std::size_t i = 0; i < products.size(); ++i) {
        Product &one = products[i];
        for (std::size_t j = i; j-- > 0 && i - j <= mostCompared && one.key - products[j].key <= rounding * size;) {
            Product &other = products[j];
            const double distance = apart(one.map, other.map, reach);
            if (distance <= rounding * (one.moved + one.norm * reach)) {
                const bool isLater = std::tie(one.first, one.second) > std::tie(other.first, other.second);
                (isLater ? one : other).isLeftOut = true;
                m_farthest = std::max(m_farthest, distance);
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
