// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "rain.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Of cells, which have a ball each, in radii: some room is left beside it.
constexpr double leastCell = 2.5;

/// Of a box along a direction.
std::pair<double, double> reachOf(const Box &box, const glm::dvec3 &direction)
{
    const glm::dvec3 half = 0.5 * box.size();
    const double middle = glm::dot(box.centre(), direction);
    const double reach = glm::dot(half, glm::abs(direction));
    return {middle - reach, middle + reach};
}

/// The cells of a layer along one direction.
struct Row {
    double from;
    double size;
    std::size_t cells;

    Row(std::pair<double, double> reach, double radius, std::size_t mostCells)
    {
        const double width = reach.second - reach.first;
        const double fitting = std::floor(width / (leastCell * radius));
        cells = fitting < static_cast<double>(mostCells) ? std::max<std::size_t>(1, static_cast<std::size_t>(fitting))
                                                         : mostCells;
        size = std::max(width / static_cast<double>(cells), leastCell * radius);
        from = 0.5 * (reach.first + reach.second) - 0.5 * size * static_cast<double>(cells);
    }

    /// share, from 0 to 1, of the room that a ball has in its cell.
    [[nodiscard]] double place(std::size_t cell, double share, double radius) const
    {
        return from + size * static_cast<double>(cell) + 1.1 * radius + share * (size - 2.2 * radius);
    }
};

}

std::vector<Ball> rainOver(const Box &box, const glm::dvec3 &gravity, const Ball &like, std::size_t count,
                           std::uint64_t seed)
{
    const double pull = glm::length(gravity);
    const glm::dvec3 up = pull > 0.0 ? -gravity / pull : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 beside = std::abs(up.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 side = glm::normalize(glm::cross(beside, up));
    const glm::dvec3 across = glm::cross(up, side);
    // Not many more cells than balls: what is over makes them larger.
    const auto mostCells = static_cast<std::size_t>(std::ceil(1.5 * std::sqrt(static_cast<double>(count)))) + 1;
    const Row sides(reachOf(box, side), like.radius, mostCells);
    const Row acrosses(reachOf(box, across), like.radius, mostCells);
    std::vector<std::size_t> cells(sides.cells * acrosses.cells);
    std::iota(cells.begin(), cells.end(), std::size_t{0});

    std::mt19937_64 random(seed);
    const auto share = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    std::vector<Ball> balls(count, like);
    double height = reachOf(box, up).second + 2.0 * like.radius;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = i % cells.size();
        if (i > 0 && at == 0) {
            height += leastCell * like.radius;
        }
        std::swap(cells[at], cells[at + random() % (cells.size() - at)]);
        balls[i].position = height * up + sides.place(cells[at] % sides.cells, share(), like.radius) * side
            + acrosses.place(cells[at] / sides.cells, share(), like.radius) * across;
    }
    return balls;
}

}
