// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "normals.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// The power of two next to the greatest absolute value; 0 of zero.
int exponentOf(const glm::dvec3 &column)
{
    const double largest = std::max({std::abs(column.x), std::abs(column.y), std::abs(column.z)});
    return largest == 0.0 || !std::isfinite(largest) ? 0 : std::ilogb(largest);
}

glm::dvec3 scaled(const glm::dvec3 &v, int exponent)
{
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

glm::dvec3 nearOne(const glm::dvec3 &v)
{
    return scaled(v, -exponentOf(v));
}

/// Columns near length 1, whatever they were: products neither overflow nor vanish.
struct Columns {
    std::array<glm::dvec3, 3> unit;
    std::array<int, 3> exponents;
};

Columns columnsOf(const glm::dmat3 &matrix)
{
    Columns columns;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        columns.exponents[at] = exponentOf(matrix[i]);
        columns.unit[at] = scaled(matrix[i], -columns.exponents[at]);
    }
    return columns;
}

double determinantOf(const std::array<glm::dvec3, 3> &unit)
{
    return glm::dot(unit[0], glm::cross(unit[1], unit[2]));
}

bool isNegative(const std::array<glm::dvec3, 3> &unit)
{
    const double lengths = glm::length(unit[0]) * glm::length(unit[1]) * glm::length(unit[2]);
    return determinantOf(unit) < -1e-13 * lengths;
}

}

bool isMirrored(const glm::dmat3 &matrix)
{
    return isNegative(columnsOf(matrix).unit);
}

glm::dmat3 normalMatrix(const glm::dmat3 &linear)
{
    const auto [unit, exponents] = columnsOf(linear);
    // Column i lacks the factor of its own exponent beside a factor common to all.
    const int least = *std::ranges::min_element(exponents);
    const double sign = isNegative(unit) ? -1.0 : 1.0;
    glm::dmat3 cofactors;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 column = glm::cross(unit[(i + 1) % 3], unit[(i + 2) % 3]);
        cofactors[static_cast<int>(i)] = sign * scaled(column, least - exponents[i]);
    }
    return cofactors;
}

glm::dvec3 transformedNormal(const glm::dmat3 &matrix, const glm::dvec3 &normal)
{
    glm::dvec3 along = matrix * normal;
    double length = glm::length(along);
    if (!(length > 1e-100 && length < 1e100)) { // squares may have vanished or overflown
        along = nearOne(matrix * nearOne(normal));
        length = glm::length(along);
    }
    return length > 0.0 ? along / length : normal;
}

}
