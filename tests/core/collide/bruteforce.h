// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <random>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/fractal/address.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/mesh.h"
#include "tests/core/fractal/randomfractals.h"
#include "tests/core/geometry/triangletruth.h"

/// The oracle of the colliders: every word of a written-out fractal, every face, in 113 bits.
namespace romanesco::test {

using Wide = boost::multiprecision::cpp_bin_float_quad;

/// A random fractal with its mesh, both ways.
struct RandomFractal {
    naive::Fractal fractal;
    Mesh mesh;
    FractalGraph graph;
};

inline glm::dvec3 randomPoint(std::mt19937_64 &random, double size)
{
    return {uniform(random, -size, size), uniform(random, -size, size), uniform(random, -size, size)};
}

inline RandomFractal randomFractalWithMesh(std::mt19937_64 &random, double largest)
{
    while (true) {
        naive::Fractal fractal = randomFractal(random, largest);
        if (naive::wordsAsWritten(fractal.levels()) <= 300) {
            Mesh mesh = randomMesh(random);
            FractalGraph graph = graphOf(fractal, mesh);
            return {std::move(fractal), std::move(mesh), std::move(graph)};
        }
    }
}

/// Similarities only; mirrored now and then.
inline RandomFractal randomSimilarFractalWithMesh(std::mt19937_64 &random, double largest)
{
    while (true) {
        naive::Fractal fractal;
        for (int i = 0; i < 4; ++i) {
            const double size = uniform(random, 0.1, largest);
            const glm::dvec3 turn(uniform(random, -180, 180), uniform(random, -180, 180), uniform(random, -180, 180));
            fractal.maps.push_back(mapFromParts(randomPoint(random, 1.5), turn, {i == 2 ? -size : size, size, size}));
        }
        fractal.sets = naive::randomSets(random, 4);
        fractal.items = naive::randomItems(random, fractal.sets.size(), 0, 3);
        if (naive::wordsAsWritten(fractal.levels()) <= 300) {
            Mesh mesh = randomMesh(random);
            FractalGraph graph = graphOf(fractal, mesh);
            return {std::move(fractal), std::move(mesh), std::move(graph)};
        }
    }
}

inline truth::Vector<Wide> wide(const glm::dvec3 &v)
{
    return {Wide(v.x), Wide(v.y), Wide(v.z)};
}

/// outer(inner), a point at a time: the maps of the picks one after another, innermost first.
inline truth::Vector<Wide> placed(const naive::Picks &picks, const std::vector<AffineMap> &maps,
                                  const glm::dvec3 &vertex)
{
    truth::Vector<Wide> point = wide(vertex);
    for (std::size_t i = picks.size(); i-- > 0;) {
        const AffineMap &map = maps[static_cast<std::size_t>(picks[i])];
        truth::Vector<Wide> next = wide(map.translation);
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < 3; ++column) {
                next[row] += Wide(map.linear[static_cast<int>(column)][static_cast<int>(row)]) * point[column];
            }
        }
        point = next;
    }
    return point;
}

inline Wide distanceToCopy(const naive::Fractal &fractal, const Mesh &mesh, const naive::Picks &picks,
                           const glm::dvec3 &p)
{
    Wide least = std::numeric_limits<double>::infinity();
    for (const Mesh::Face &face : mesh.faces) {
        std::array<truth::Vector<Wide>, 3> triangle;
        for (std::size_t i = 0; i < 3; ++i) {
            triangle[i] = placed(picks, fractal.maps, mesh.vertices[face[i]]);
        }
        least = std::min(least, truth::distance<Wide>(triangle, wide(p)));
    }
    return least;
}

inline Wide distanceToAll(const RandomFractal &sample, const glm::dvec3 &p)
{
    Wide least = std::numeric_limits<double>::infinity();
    for (const naive::Picks &picks : naive::allPicks(sample.fractal.levels())) {
        least = std::min(least, distanceToCopy(sample.fractal, sample.mesh, picks, p));
    }
    return least;
}

/// Numbers of the maps that an address picks.
inline naive::Picks picksOf(const Address &address, const naive::Fractal &fractal)
{
    naive::Picks picks;
    const naive::Levels levels = fractal.levels();
    for (const Pick &pick : address) {
        picks.push_back(levels.at(pick.position).maps.at(pick.map));
    }
    return picks;
}

}
