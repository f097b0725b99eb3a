// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

/// Polygons of the plane that turn left and do not cross themselves, and what a triangulation of any has to be.
namespace romanesco::test {

using Polygon = std::vector<glm::dvec2>;
using PolygonRandom = std::mt19937_64;

inline double uniform(PolygonRandom &random)
{
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Twice the area, by the shoelace formula round the first corner.
inline double twiceArea(std::span<const glm::dvec2> corners)
{
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec2 a = corners[i] - corners[0];
        const glm::dvec2 b = corners[i + 1] - corners[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// Corners in order round a point that sees them all, near and far.
inline Polygon starPolygon(std::size_t count, PolygonRandom &random)
{
    Polygon corners;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle =
            (static_cast<double>(i) + 0.9 * uniform(random)) / static_cast<double>(count) * 6.283185307179586;
        const double radius = 0.1 + uniform(random);
        corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return corners;
}

/// Any simple polygon: a random tour with its crossings taken out, each of which makes it shorter. Cost n^3 or so.
inline Polygon tourPolygon(std::size_t count, PolygonRandom &random)
{
    Polygon corners;
    for (std::size_t i = 0; i < count; ++i) {
        corners.emplace_back(uniform(random), uniform(random));
    }
    const auto side = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
    };
    for (bool isCrossed = true; isCrossed;) {
        isCrossed = false;
        for (std::size_t i = 0; i + 2 < count; ++i) {
            for (std::size_t j = i + 2; j < count && !(i == 0 && j + 1 == count); ++j) {
                const auto [a, b, c, d] = std::array{corners[i], corners[i + 1], corners[j], corners[(j + 1) % count]};
                if (side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)) {
                    std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                 corners.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                    isCrossed = true;
                }
            }
        }
    }
    if (twiceArea(corners) < 0) {
        std::ranges::reverse(corners);
    }
    return corners;
}

/// The outline of a set of squares that hang together without a hole, with a corner at every step: many in line.
inline Polygon treePolygon(std::size_t squares, PolygonRandom &random)
{
    using Place = std::pair<int, int>;
    constexpr std::array<Place, 4> steps{Place{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    std::set<Place> filled{{0, 0}};
    std::vector<Place> order{{0, 0}};
    // A square may be added where of its eight neighbours few are filled and these are one piece, which touches it by an
    // edge.
    for (std::size_t tries = 0; filled.size() < squares && tries < 50 * squares; ++tries) {
        const Place from = order[random() % order.size()];
        const Place step = steps[random() % 4];
        const Place at{from.first + step.first, from.second + step.second};
        const auto isFilled = [&](int dx, int dy) { return filled.contains({at.first + dx, at.second + dy}); };
        constexpr std::array<Place, 8> round{Place{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
        int changes = 0;
        int count = 0;
        for (std::size_t i = 0; i < 8; ++i) {
            const Place &a = round[i];
            const Place &b = round[(i + 1) % 8];
            count += isFilled(a.first, a.second);
            changes += isFilled(a.first, a.second) != isFilled(b.first, b.second);
        }
        if (changes == 2 && count <= 3 && !filled.contains(at)) {
            filled.insert(at);
            order.push_back(at);
        }
    }
    // Edges with the filled square to their left, from where each starts.
    std::map<Place, Place> edges;
    for (const auto &[x, y] : filled) {
        const std::array<Place, 4> corners{Place{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
        constexpr std::array<Place, 4> across{Place{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
        for (std::size_t i = 0; i < 4; ++i) {
            if (!filled.contains({x + across[i].first, y + across[i].second})) {
                edges[corners[i]] = corners[(i + 1) % 4];
            }
        }
    }
    Polygon outline;
    const Place first = edges.begin()->first;
    Place at = first;
    do {
        outline.emplace_back(at.first, at.second);
        at = edges.at(at);
    } while (at != first);
    return outline;
}

/// A bar with teeth: four corners a tooth.
inline Polygon combPolygon(std::size_t teeth)
{
    Polygon corners;
    const auto count = static_cast<double>(teeth);
    corners.emplace_back(2 * count, -1);
    for (std::size_t i = teeth; i-- > 0;) {
        const auto x = 2 * static_cast<double>(i);
        corners.emplace_back(x + 1, 0);
        corners.emplace_back(x + 1, 10 * count);
        corners.emplace_back(x, 10 * count);
        corners.emplace_back(x, 0);
    }
    corners.emplace_back(0, -1);
    std::ranges::rotate(corners, corners.end() - 1);
    return corners;
}

/// A band that winds inwards.
inline Polygon spiralPolygon(std::size_t count)
{
    Polygon corners;
    const auto point = [](double turns, double radius) {
        return glm::dvec2(radius * std::cos(6.283185307179586 * turns), radius * std::sin(6.283185307179586 * turns));
    };
    const std::size_t half = count / 2;
    for (std::size_t i = 0; i < half; ++i) {
        const double turns = static_cast<double>(i) / 40;
        corners.push_back(point(turns, 2 + turns));
    }
    for (std::size_t i = half; i-- > 0;) {
        const double turns = static_cast<double>(i) / 40;
        corners.push_back(point(turns, 1.6 + turns));
    }
    return corners;
}

/// A bar with square holes, each reached by a bridge from the lower edge and back, as in files that know no holes.
inline Polygon holedPolygon(std::size_t holes)
{
    Polygon corners{{0, 0}};
    for (std::size_t i = 0; i < holes; ++i) {
        const auto x = 3 * static_cast<double>(i) + 1;
        for (const glm::dvec2 &corner : {glm::dvec2(x, 0), {x, 1}, {x, 2}, {x + 1, 2}, {x + 1, 1}, {x, 1}, {x, 0}}) {
            corners.push_back(corner);
        }
    }
    const auto width = 3 * static_cast<double>(holes);
    corners.emplace_back(width, 0);
    corners.emplace_back(width, 3);
    corners.emplace_back(0, 3);
    return corners;
}

}
