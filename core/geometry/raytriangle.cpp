// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "raytriangle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

RayOnTriangles::RayOnTriangles(const glm::dvec3 &direction)
{
    const glm::dvec3 size = glm::abs(direction);
    const int along = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    assert(size[along] > 0.5 && "of three coordinates of a unit vector one is above a half");
    m_axes = {along, (along + 1) % 3, (along + 2) % 3};
    m_shear = {1.0 / direction[along], direction[m_axes[1]] / direction[along],
               direction[m_axes[2]] / direction[along]};
}

std::optional<double> RayOnTriangles::wayTo(const Triangle &triangle) const
{
    std::array<double, 3> x;
    std::array<double, 3> y;
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = triangle[i][m_axes[0]];
        x[i] = triangle[i][m_axes[1]] - m_shear.y * along;
        y[i] = triangle[i][m_axes[2]] - m_shear.z * along;
    }
    // Twice the areas that the origin makes with the sides. The same side the other way round gives the opposite number.
    const double u = x[2] * y[1] - y[2] * x[1];
    const double v = x[0] * y[2] - y[0] * x[2];
    const double w = x[1] * y[0] - y[1] * x[0];
    const auto [least, greatest] = std::minmax({u, v, w});
    if (least < 0.0 && greatest > 0.0) {
        return std::nullopt;
    }
    const double whole = u + v + w;
    if (whole == 0.0) {
        return std::nullopt; // seen from the side, or no face at all
    }
    const auto depth = [&](std::size_t corner) { return triangle[corner][m_axes[0]] * m_shear.x; };
    return u / whole * depth(0) + v / whole * depth(1) + w / whole * depth(2);
}

}
