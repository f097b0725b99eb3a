// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/fractal/boxbounds.h"
#include "tests/core/fractal/randomfractals.h"

/// Boxes and the truth about them.
namespace romanesco::test {

/// In long doubles.
struct ExactBox {
    std::array<long double, 3> least{INFINITY, INFINITY, INFINITY};
    std::array<long double, 3> greatest{-INFINITY, -INFINITY, -INFINITY};

    void add(const naive::Point &point)
    {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            least[axis] = std::min(least[axis], point[axis]);
            greatest[axis] = std::max(greatest[axis], point[axis]);
        }
    }

    void add(const ExactBox &box)
    {
        add(box.least);
        add(box.greatest);
    }

    [[nodiscard]] long double size() const
    {
        return std::max({greatest[0] - least[0], greatest[1] - least[1], greatest[2] - least[2]});
    }
};

inline bool holds(const Box &box, const naive::Point &point, long double slack = 0)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        const long double more = slack * (1 + std::abs(point[axis]));
        if (point[axis] < box.least[i] - more || point[axis] > box.greatest[i] + more) {
            return false;
        }
    }
    return true;
}

/// How far the sides of a box are out, the farthest one in parts of the exact box's largest side, but for rounding;
/// negative where one is inside.
inline long double excess(const Box &box, const ExactBox &exact)
{
    long double farthest = -INFINITY;
    long double nearest = INFINITY;
    long double largest = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int i = static_cast<int>(axis);
        for (long double out : {exact.least[axis] - box.least[i], box.greatest[i] - exact.greatest[axis]}) {
            out = std::abs(out) < 1e-300L ? 0 : out; // what no double holds
            largest = std::max({largest, std::abs(exact.least[axis]), std::abs(exact.greatest[axis])});
            farthest = std::max(farthest, out);
            nearest = std::min(nearest, out);
        }
    }
    return (nearest < 0 ? nearest : farthest) / (exact.size() + 1e-9L * largest);
}

/// Holds the truth, and no side is farther out than that part of the largest.
inline bool isTight(const Box &box, const ExactBox &truth, long double part)
{
    const long double out = excess(box, truth);
    return out >= 0 && out <= part;
}

/// A set of these maps, so often.
inline naive::Fractal repeated(std::vector<AffineMap> maps, bool mayPass, std::uint64_t depth)
{
    naive::Fractal fractal;
    fractal.sets = {{{}, mayPass}};
    for (std::size_t i = 0; i < maps.size(); ++i) {
        fractal.sets.front().maps.push_back(static_cast<int>(i));
    }
    fractal.maps = std::move(maps);
    fractal.items = {{depth, 0, {{0, 0, {}}}}};
    return fractal;
}

/// From -0.5, -1, 0 to 0.5, 1, 2.
inline Mesh wedge()
{
    Mesh mesh;
    mesh.vertices = {{-0.5, -1, 0}, {0.5, 0, 2}, {0, 1, 1}};
    mesh.faces = {{0, 1, 2}};
    return mesh;
}

inline AffineMap moved(double x, double y, double z)
{
    return {glm::dmat3(1.0), {x, y, z}};
}

inline Box boxAt(const naive::Fractal &fractal, const Mesh &mesh, Position position)
{
    const FractalGraph graph = graphOf(fractal, mesh);
    return BoxBounds(graph, mesh).at(graph, position);
}

}
