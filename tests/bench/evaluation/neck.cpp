// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "neck.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/geometry/box.h"

namespace romanesco::bench {

namespace {

constexpr int pointsAlong = 72;
constexpr int finerPointsAlong = 24;

/// Room for a ball's centre, sampled: how large the ball may be at each point.
class Grid
{
public:
    Grid(Search &search, const Box &box, double spacing)
        : m_least(box.least)
        , m_spacing(spacing)
        , m_count(glm::ivec3(glm::ceil(box.size() / spacing)) + 1)
        , m_room(static_cast<std::size_t>(m_count.x) * m_count.y * m_count.z)
    {
        Hit hit;
        for (std::size_t i = 0; i < m_room.size(); ++i) {
            search.closest({.p = place(i)}, hit);
            m_room[i] = hit.distance;
        }
    }

    [[nodiscard]] glm::dvec3 place(std::size_t i) const { return m_least + m_spacing * glm::dvec3(cell(i)); }
    [[nodiscard]] double room(std::size_t i) const { return m_room[i]; }
    [[nodiscard]] double spacing() const { return m_spacing; }

    [[nodiscard]] std::size_t at(const glm::dvec3 &p) const
    {
        const glm::ivec3 cell(glm::round((p - m_least) / m_spacing));
        return index(glm::clamp(cell, glm::ivec3(0), m_count - 1));
    }

    /// Points from one back to the first that is an end, the least of whose rooms is greatest: always on from the roomiest
    /// that was reached. There must be an end.
    template<typename IsEnd>
    [[nodiscard]] std::vector<std::size_t> widest(std::size_t from, IsEnd isEnd) const
    {
        constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max();
        std::vector<std::size_t> before(m_room.size(), unknown);
        std::priority_queue<std::pair<double, std::size_t>> open;
        before[from] = from;
        open.emplace(m_room[from], from);
        while (!isEnd(open.top().second)) {
            const auto [width, i] = open.top();
            open.pop();
            const glm::ivec3 middle = cell(i);
            for (int n = 0; n < 27; ++n) {
                const glm::ivec3 next = middle + glm::ivec3(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
                if (glm::clamp(next, glm::ivec3(0), m_count - 1) == next && before[index(next)] == unknown) {
                    before[index(next)] = i;
                    open.emplace(std::min(width, m_room[index(next)]), index(next));
                }
            }
        }
        std::vector<std::size_t> way{open.top().second};
        while (way.back() != from) {
            way.push_back(before[way.back()]);
        }
        return way;
    }

private:
    [[nodiscard]] std::size_t index(const glm::ivec3 &cell) const
    {
        return (static_cast<std::size_t>(cell.z) * m_count.y + cell.y) * m_count.x + cell.x;
    }
    [[nodiscard]] glm::ivec3 cell(std::size_t i) const
    {
        const auto n = static_cast<int>(i);
        return {n % m_count.x, n / m_count.x % m_count.y, n / m_count.x / m_count.y};
    }

    glm::dvec3 m_least;
    double m_spacing;
    glm::ivec3 m_count;
    std::vector<double> m_room;
};

Box around(const glm::dvec3 &a, const glm::dvec3 &b, double margin)
{
    return {glm::min(a, b) - margin, glm::max(a, b) + margin};
}

double longestSide(const Box &box)
{
    return std::max({box.size().x, box.size().y, box.size().z});
}

template<typename IsEnd>
Neck widestWay(const Collider &exact, const Ways &ways, IsEnd isEnd)
{
    const auto search = exact.search();
    Box box = around(ways.from, ways.to, ways.margin);
    glm::dvec3 start = ways.from;
    std::optional<glm::dvec3> end;
    Neck neck;
    int along = pointsAlong;
    for (double spacing = ways.margin; spacing > 1e-3 * ways.margin; along = finerPointsAlong) {
        box.greatest.y = std::min(box.greatest.y, ways.highest);
        spacing = longestSide(box) / along;
        const Grid grid(*search, box, spacing);
        const std::vector<std::size_t> way =
            grid.widest(grid.at(start), [&](std::size_t i) { return end ? i == grid.at(*end) : isEnd(grid, i); });
        // nowhere is a way farther from a point of the grid than half a diagonal of a cell
        if (!end) {
            neck.missed = 0.5 * std::numbers::sqrt3 * spacing;
        }
        const auto narrowest = std::ranges::min_element(way, {}, [&](std::size_t i) { return grid.room(i); });
        neck.radius = std::max(neck.radius, grid.room(*narrowest));
        neck.centre = grid.place(*narrowest);

        // the part of the way within three cells goes on
        const auto isNear = [&](std::size_t i) {
            const glm::dvec3 off = glm::abs(grid.place(i) - neck.centre);
            return std::max({off.x, off.y, off.z}) < 3.5 * spacing;
        };
        auto first = narrowest;
        while (first != way.begin() && isNear(*(first - 1))) {
            --first;
        }
        auto last = narrowest;
        while (last + 1 != way.end() && isNear(*(last + 1))) {
            ++last;
        }
        end = grid.place(*first);
        start = grid.place(*last);
        box = around(neck.centre, neck.centre, 4.0 * spacing);
    }
    return neck;
}

}

Neck widestWayTo(const Collider &exact, const Ways &ways)
{
    return widestWay(exact, ways, [&](const Grid &grid, std::size_t i) { return i == grid.at(ways.to); });
}

Neck widestWayDown(const Collider &exact, const Ways &ways)
{
    return widestWay(exact, ways, [&](const Grid &grid, std::size_t i) { return grid.place(i).y <= ways.to.y; });
}

}
