// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fractal/fractalgraph.h"
#include "descent.h"

namespace romanesco {

/// Pairs of picks that place a copy where an earlier pair of the same two sets does, but for rounding: as where maps
/// commute. Such copies multiply with each level, and under no bound does one drop the other. A search that leaves out
/// the second pick after the first one still meets every place: a word's picks can be exchanged until none is left out,
/// since each exchange makes it come earlier.
///
/// There are none where sets share maps, where a map shrinks to more than 0.85, and of two sets of more than 4,096 pairs;
/// at most 65,536 pairs are looked at.
class EqualProducts
{
public:
    struct Pick {
        SetId set = 0;
        std::uint32_t map = 0;

        bool operator==(const Pick &) const = default;
    };

    /// Cost: up to a microsecond a pair.
    explicit EqualProducts(const FractalGraph &graph);

    /// Whether nothing is left out.
    [[nodiscard]] bool isEmpty() const { return m_isEmpty; }

    /// What need not follow a pick.
    [[nodiscard]] std::span<const Pick> leftOutAfter(SetId set, std::uint32_t map) const
    {
        return m_isEmpty ? std::span<const Pick>{} : m_leftOut[set][map];
    }

    /// Whether all that need not follow one step need not follow another either.
    [[nodiscard]] bool leavesOutNoMore(const DescentStep &after, const DescentStep &thanAfter) const;

    /// How far from a copy that is left out the one is at most that is met instead, in parts of the numbers that it is
    /// placed by: a word is exchanged several times on its way, less and less of it each time.
    [[nodiscard]] double error() const { return 128.0 * m_apart; }

    [[nodiscard]] std::size_t memoryUse() const;

    /// Puts infinity in place of the numbers of those children of a state that need not follow the last step of a path.
    void leaveOut(std::span<const DescentStep> path, std::span<const DescentStep> children, double *numbers) const;

private:
    struct Product;
    [[nodiscard]] static std::vector<Product> productsOf(const FractalGraph &graph, SetId first, SetId second);
    void compare(std::vector<Product> &products, SetId first, SetId second);

    /// By set and map.
    std::vector<std::vector<std::vector<Pick>>> m_leftOut;
    bool m_isEmpty = true;
    /// Of the numbers that products are made of.
    double m_apart = 0.0;
};

}
