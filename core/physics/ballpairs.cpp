// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballpairs.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Beside the radii: what touches but for rounding, and is pushed out of a surface.
constexpr double margin = 1e-3;

/// A cube of a place's grid. Its sides are a power of two, its number along each axis a whole one.
struct Cell {
    std::uint32_t place = 0;
    int level = 0;
    glm::dvec3 number{0.0};

    bool operator==(const Cell &) const = default;
};

Cell cellAt(int level, const BallState &ball)
{
    return {ball.place, level, glm::floor(ball.position / std::ldexp(1.0, level))};
}

/// Grids of all levels that are in use. A ball is in one whose cells are as wide as it reaches across, or up to twice as
/// wide: so what two balls that meet are in, by the coarser one, is one cell or two side by side.
class Grids
{
public:
    explicit Grids(std::size_t count)
        : m_firsts(std::bit_ceil(2 * count + 2), none)
        , m_shift(64 - std::countr_zero(m_firsts.size()))
    {
        m_cells.reserve(count);
        m_nexts.reserve(count);
    }

    /// The balls in order.
    void add(const BallState &ball, double reach)
    {
        int level = 0;
        (void)std::frexp(2.0 * reach, &level);
        m_cells.push_back(cellAt(level, ball));
        std::size_t &first = m_firsts[placeOf(m_cells.back())];
        m_nexts.push_back(std::exchange(first, m_cells.size() - 1));
        if (std::ranges::find(m_levels, level) == m_levels.end()) {
            m_levels.push_back(level);
        }
    }

    /// Each ball that may meet a ball, from one of both; more than once where numbers of cells are so large that they round to
    /// one another.
    template<typename Visit>
    void visitNear(std::size_t ball, const BallState &state, Visit &&visit) const
    {
        for (const int level : m_levels) {
            if (level < m_cells[ball].level) {
                continue;
            }
            // of two cells of one level one is visited from the other
            const bool isOwn = level == m_cells[ball].level;
            const Cell middle = cellAt(level, state);
            for (int i = 0; i < (isOwn ? middleOf27 + 1 : 27); ++i) {
                const glm::dvec3 off(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
                visitCell({middle.place, level, middle.number + off}, [&](std::size_t other) {
                    if (isOwn && i == middleOf27 ? other < ball : other != ball) {
                        visit(other);
                    }
                });
            }
        }
    }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    static constexpr int middleOf27 = 13;

    template<typename Visit>
    void visitCell(const Cell &cell, Visit &&visit) const
    {
        for (std::size_t other = m_firsts[placeOf(cell)]; other != none; other = m_nexts[other]) {
            if (m_cells[other] == cell) {
                visit(other);
            }
        }
    }

    [[nodiscard]] std::size_t placeOf(const Cell &cell) const
    {
        auto key = static_cast<std::uint64_t>(cell.level) ^ std::uint64_t{cell.place} << 32;
        for (const double number : {cell.number.x, cell.number.y, cell.number.z}) {
            // + 0.0: there is one zero; of a product the high digits depend on all (Knuth 1973, 6.4)
            key = std::rotl((key ^ std::bit_cast<std::uint64_t>(number + 0.0)) * 0x9e3779b97f4a7c15, 32);
        }
        return (key * 0x9e3779b97f4a7c15) >> m_shift;
    }

    std::vector<Cell> m_cells;
    std::vector<int> m_levels;
    /// The last ball that was put at a place, and for each the one before it.
    std::vector<std::size_t> m_firsts;
    std::vector<std::size_t> m_nexts;
    int m_shift;
};

std::size_t rootOf(std::vector<std::size_t> &parents, std::size_t ball)
{
    while (parents[ball] != ball) {
        ball = parents[ball] = parents[parents[ball]];
    }
    return ball;
}

}

double reachOf(const BallState &ball, const Laws &laws, double time)
{
    const double way = ball.isAsleep ? 0.0 : longestWay(ball.velocity, laws.gravityOn(ball), time);
    return ball.radius * (1.0 + margin) + way;
}

std::vector<BallPair> nearPairs(std::span<const BallState> balls, std::span<const double> reaches)
{
    Grids grids(balls.size());
    for (std::size_t i = 0; i < balls.size(); ++i) {
        grids.add(balls[i], reaches[i]);
    }
    std::vector<BallPair> pairs;
    for (std::size_t ball = 0; ball < balls.size(); ++ball) {
        const BallState &one = balls[ball];
        grids.visitNear(ball, one, [&](std::size_t next) {
            const BallState &other = balls[next];
            const glm::dvec3 apart = one.position - other.position;
            const double reach = reaches[ball] + reaches[next];
            const bool isAwake = !one.isAsleep || !other.isAsleep;
            const bool isPiled = one.isPiled && other.isPiled;
            if ((isAwake || isPiled) && glm::dot(apart, apart) <= reach * reach) {
                pairs.push_back({std::min(ball, next), std::max(ball, next)});
            }
        });
    }
    std::ranges::sort(pairs);
    const auto again = std::ranges::unique(pairs);
    pairs.erase(again.begin(), again.end());
    return pairs;
}

std::vector<BallIsland> islandsOf(std::span<const BallState> balls, std::span<const BallPair> pairs)
{
    std::vector<std::size_t> parents(balls.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (const BallPair &pair : pairs) {
        const std::size_t one = rootOf(parents, pair.one);
        const std::size_t other = rootOf(parents, pair.other);
        parents[std::max(one, other)] = std::min(one, other); // the root is the first ball
    }
    std::map<std::size_t, BallIsland> islands;
    for (const BallPair &pair : pairs) {
        islands[rootOf(parents, pair.one)].pairs.push_back(pair);
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto island = islands.find(rootOf(parents, i));
        if (island != islands.end()) {
            island->second.balls.push_back(i);
        }
    }
    std::vector<BallIsland> awake;
    for (auto &[root, island] : islands) {
        if (std::ranges::any_of(island.balls, [&](std::size_t ball) { return !balls[ball].isAsleep; })) {
            awake.push_back(std::move(island));
        }
    }
    return awake;
}

}
