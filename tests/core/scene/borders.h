// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <format>
#include <random>
#include <string>
#include <vector>

#include "core/scene/anchor.h"
#include "tests/core/scene/longplaces.h"
#include "tests/testmain.h"

/// Places at borders, of which the other side is as near.
namespace romanesco::test {

inline std::string withMaps(const std::vector<std::string> &maps, int depth)
{
    std::string text = "x. \"m.obj\"\n";
    std::string names;
    for (std::size_t i = 0; i < maps.size(); ++i) {
        const std::string name = std::to_string(i);
        text += std::format("m{}. {}\n", i, maps[i]);
        names += (i ? ", m" : "m") + name;
    }
    return std::format("{}z<x>. [{}] x\n<$>. z {}\n", text, names, depth);
}

using Cell = std::array<int, 3>;

/// Of 64 cells those on the surface, but for the middles of its sides: their places are exact, as a third's are not.
inline std::vector<Cell> shellCells()
{
    std::vector<Cell> cells;
    for (int i = 0; i < 64; ++i) {
        const Cell cell{i % 4, i / 4 % 4, i / 16};
        if (std::ranges::count_if(cell, [](int x) { return x == 1 || x == 2; }) < 2) {
            cells.push_back(cell);
        }
    }
    return cells;
}

inline std::uint32_t shellMap(const Cell &cell)
{
    const std::vector<Cell> cells = shellCells();
    return static_cast<std::uint32_t>(std::ranges::find(cells, cell) - cells.begin());
}

/// A vector is three numbers in a line of its own.
inline std::string text(const std::vector<std::array<std::string, 3>> &maps, int depth)
{
    std::string vectors;
    std::vector<std::string> parts;
    for (const auto &map : maps) {
        for (const std::string &part : map) {
            vectors += "v " + part + "\n";
        }
        const std::size_t last = 3 * parts.size() + 3;
        parts.push_back(std::format("({}, {}, {})", last - 2, last - 1, last));
    }
    return vectors + withMaps(parts, depth);
}

/// A way down on which another, which parts from it at once, comes as near all the time.
struct Border {
    std::shared_ptr<const Scene> scene;
    std::vector<std::uint32_t> path;
    std::size_t otherItem = 0;
    std::vector<std::uint32_t> other;
};

inline Border borderOf(const QString &name, std::size_t depth)
{
    const int levels = static_cast<int>(depth) + 5;
    Border border;
    if (name == QLatin1String("point") || name == QLatin1String("items")) {
        const auto model = modelOf(QStringLiteral("sierpinski"), depth + 5);
        border.path.assign(depth, 1);
        border.other.assign(depth, 0);
        border.scene = sceneOf({{.model = model}, {.model = model, .worldFromModel = {glm::dmat3(1.0), {2, 0, 0}}}});
        border.otherItem = 1;
        if (name == QLatin1String("point")) {
            border.scene = sceneOf({{.model = model}});
            border.otherItem = 0;
            std::swap(border.path[0], border.other[0]);
        }
        return border;
    }
    if (name == QLatin1String("turned") || name == QLatin1String("uneven")) {
        // copies of one place, in which the third map stays at the origin
        const bool isTurned = name == QLatin1String("turned");
        border.scene =
            sceneOf({{.model = modelOf(
                          text({{"0.75 0.5 0.5", "10 20 30", "0.25 0.25 0.25"},
                                {"0.75 0.5 0.5", "-100 50 170", isTurned ? "0.25 0.25 0.25" : "0.2 0.3 0.25"},
                                {"0 0 0", isTurned ? "33 71 -12" : "0 0 90", isTurned ? "0.5 0.5 0.5" : "0.5 0.32 0.4"},
                                {"-0.6 0.7 0.1", "60 0 10", "0.3 0.3 0.3"}},
                               levels)),
                      .worldFromModel = mapFromParts({1, 2, 3}, {10, 20, 30}, glm::dvec3(3))}});
        border.path.assign(depth, 2);
        border.other.assign(depth, 2);
        border.path[0] = 0;
        border.other[0] = 1;
        // not quite to where they touch
        std::ranges::fill(std::span(border.path).last(2), 3);
        return border;
    }
    std::vector<std::array<std::string, 3>> maps;
    for (const Cell &cell : shellCells()) {
        maps.push_back(
            {std::format("{} {} {}", 0.75 * cell[0], 0.75 * cell[1], 0.75 * cell[2]), "0 0 0", "0.25 0.25 0.25"});
    }
    border.scene = sceneOf({{.model = modelOf(text(maps, levels))}});
    const bool isEdge = name == QLatin1String("edge");
    border.path.push_back(shellMap({0, 0, 0}));
    border.other.push_back(shellMap({1, 0, 0}));
    std::mt19937_64 random(seed(9));
    while (border.path.size() < depth) {
        const int across = isEdge ? 3 : static_cast<int>(random() % 4);
        const int along = across % 3 ? 0 : static_cast<int>(random() % 4);
        border.path.push_back(shellMap({3, across, along}));
        border.other.push_back(shellMap({0, across, along}));
    }
    return border;
}

inline Anchor anchorAt(const Border &border)
{
    Anchor anchor(border.scene);
    if (!anchor.enter({0, 0})) {
        qFatal("no item");
    }
    for (const std::uint32_t map : border.path) {
        if (!anchor.enter({0, map})) {
            qFatal("no way");
        }
    }
    return anchor;
}

inline std::vector<Step> stepsOf(const Surroundings &all, const Surroundings::Node &node)
{
    std::vector<Step> steps(all.path.begin(), all.path.begin() + static_cast<std::ptrdiff_t>(node.sharedSteps));
    steps.insert(steps.end(), node.steps.begin(), node.steps.end());
    return steps;
}

inline bool leadsTo(const Surroundings &all, const Surroundings::Node &node, std::size_t item,
                    const std::vector<std::uint32_t> &maps)
{
    const std::vector<Step> steps = stepsOf(all, node);
    return node.item == item && !node.isMeshOnly && steps.size() <= maps.size()
        && std::ranges::equal(steps, std::span(maps).first(steps.size()), {}, &Step::map);
}

}
