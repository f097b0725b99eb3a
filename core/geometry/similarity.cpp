// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "similarity.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace romanesco {

namespace {

/// Of the squares of the axes and of their products, in the mean axis' square: a few roundings.
constexpr double mostDefect = 1e-14;

/// That of a similarity to the last digit, where an operator norm would be an upper bound.
double meanScale(const glm::dmat3 &linear)
{
    const double largest = operatorNorm(linear);
    double squares = 0.0;
    for (int column = 0; column < 3; ++column) {
        const glm::dvec3 axis = linear[column] / largest;
        squares += glm::dot(axis, axis);
    }
    return largest * std::sqrt(squares / 3.0);
}

bool keepsAngles(const glm::dmat3 &linear, double scale)
{
    const glm::dmat3 unit = linear / scale;
    const glm::dmat3 defect = glm::transpose(unit) * unit - glm::dmat3(1.0);
    double most = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            most = std::max(most, std::abs(defect[column][row]));
        }
    }
    return most <= mostDefect;
}

}

std::optional<Similarity> similarityOf(const AffineMap &map)
{
    const std::optional<AffineMap> back = inverse(map);
    if (!back) {
        return std::nullopt;
    }
    const double scale = meanScale(map.linear);
    return keepsAngles(map.linear, scale) ? std::optional(Similarity{map, *back, scale}) : std::nullopt;
}

}
