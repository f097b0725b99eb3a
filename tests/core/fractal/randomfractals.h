// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <random>

#include "core/fractal/fractalgraph.h"
#include "core/geometry/affinemap.h"
#include "core/geometry/mesh.h"
#include "tests/core/naive.h"

/// Fractals of every kind, small enough to be written out.
namespace romanesco::test {

inline double uniform(std::mt19937_64 &random, double least, double greatest)
{
    return std::uniform_real_distribution<double>(least, greatest)(random);
}

/// Similar, unequal, mirrored, flat or sheared; of norm `largest` at most, or nearly.
inline AffineMap randomMap(std::mt19937_64 &random, double largest)
{
    const auto angle = [&] { return uniform(random, -360, 360); };
    const auto size = [&] { return uniform(random, 0.2 * largest, largest); };
    glm::dvec3 scale(size());
    switch (random() % 6) {
    case 0:
        scale = {size(), size(), size()};
        break;
    case 1:
        scale.x = -scale.x;
        break;
    case 2:
        scale.z = 0;
        break;
    default:
        break;
    }
    AffineMap map = mapFromParts({uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2)},
                                 {angle(), angle(), angle()}, scale);
    if (random() % 6 == 0) {
        map.linear[1] += 0.2 * largest * map.linear[0];
    }
    return map;
}

inline naive::Fractal randomFractal(std::mt19937_64 &random, double largest)
{
    while (true) {
        naive::Fractal fractal;
        for (int i = 0; i < 3; ++i) {
            fractal.maps.push_back(randomMap(random, largest));
        }
        fractal.sets = naive::randomSets(random, 3);
        fractal.items = naive::randomItems(random, fractal.sets.size(), 0, 9);
        const naive::Levels levels = fractal.levels();
        if (levels.size() >= 2 && levels.size() <= 24 && naive::wordsAsWritten(levels) <= 3'000) {
            return fractal;
        }
    }
}

/// Several repeats, some of very many passes, and levels between them. Most maps contract; some only turn and move.
inline naive::Fractal randomLongFractal(std::mt19937_64 &random)
{
    naive::Fractal fractal;
    for (int i = 0; i < 4; ++i) {
        fractal.maps.push_back(randomMap(random, std::array{0.3, 0.8, 0.97}[random() % 3]));
        if (random() % 4 == 0) {
            fractal.maps.back() = mapFromParts({uniform(random, -2, 2), 1, 0}, {0, uniform(random, -90, 90), 0},
                                               {1, random() % 2 == 0 ? 1 : -1, 1});
        }
    }
    fractal.sets = naive::randomSets(random, 4);
    const std::uint64_t repeats = random() % 3 + 1;
    for (std::uint64_t i = 0; i < repeats; ++i) {
        const std::uint64_t count = std::array{3ull, 100ull, 1'000'000ull, 1'000'000'000'000ull}[random() % 4];
        for (naive::Fractal::Item &item : naive::randomItems(random, fractal.sets.size(), 2, 4)) {
            fractal.items.push_back(std::move(item));
        }
        fractal.items.push_back({count, 0, naive::randomItems(random, fractal.sets.size(), 1, 70)});
    }
    return fractal;
}

inline Mesh randomMesh(std::mt19937_64 &random)
{
    Mesh mesh;
    const glm::dvec3 offset(uniform(random, -3, 3), 0, uniform(random, -1, 1));
    for (int i = 0; i < 4; ++i) {
        mesh.vertices.push_back(offset
                                + glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)));
    }
    mesh.faces = {{0, 1, 2}, {1, 2, 3}};
    return mesh;
}

inline FractalGraph graphOf(const naive::Fractal &fractal, const Mesh &mesh)
{
    return FractalGraph::build(fractal.description(), boundingSphere(mesh)).value();
}

/// The corners of all faces.
inline std::vector<naive::Point> points(const Mesh &mesh)
{
    std::vector<naive::Point> all;
    for (const auto &face : mesh.faces) {
        for (const std::uint32_t index : face) {
            const glm::dvec3 &v = mesh.vertices[index];
            all.push_back({v.x, v.y, v.z});
        }
    }
    return all;
}

/// The levels of any description as maps, for folding points through them.
struct Folder {
    explicit Folder(const FractalDescription &description)
        : levels(description.levels)
    {
        for (const TransformSet &set : description.sets) {
            std::vector<naive::Affine> &list = maps.emplace_back();
            for (const AffineMap &map : set.maps) {
                list.push_back(naive::fromCore(map));
            }
            if (set.holdsIdentity) {
                list.emplace_back();
            }
        }
    }

    /// Through one map of a level, or past it.
    [[nodiscard]] naive::Point fold(Position position, const naive::Point &point, std::mt19937_64 &random) const
    {
        const std::vector<naive::Affine> &list = maps[levels.set(levels.locate(position).slot)];
        return naive::applied(list[random() % list.size()], point);
    }

    const LevelSequence &levels;
    std::vector<std::vector<naive::Affine>> maps;
};

}
