// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "affinemap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "rotation.h"

namespace romanesco {

namespace {

/// The largest eigenvalue of a symmetric matrix by cyclic Jacobi rotations, to a few units in the last place of its
/// norm (Golub and Van Loan 2013, 8.5). Six sweeps are more than a 3x3 matrix needs; the loop ends when it is diagonal.
double largestEigenvalue(glm::dmat3 a)
{
    for (int sweep = 0; sweep < 16; ++sweep) {
        const double off = std::abs(a[0][1]) + std::abs(a[0][2]) + std::abs(a[1][2]);
        const double diagonal = std::abs(a[0][0]) + std::abs(a[1][1]) + std::abs(a[2][2]);
        if (off <= 1e-17 * diagonal) {
            break;
        }
        for (int p = 0; p < 2; ++p) {
            for (int q = p + 1; q < 3; ++q) {
                if (a[p][q] == 0.0) {
                    continue;
                }
                const double theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
                const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::sqrt(theta * theta + 1.0));
                const double c = 1.0 / std::sqrt(t * t + 1.0);
                glm::dmat3 rotation(1.0);
                rotation[p][p] = c;
                rotation[q][q] = c;
                rotation[p][q] = -t * c;
                rotation[q][p] = t * c;
                a = glm::transpose(rotation) * a * rotation;
            }
        }
    }
    return std::max({a[0][0], a[1][1], a[2][2]});
}

/// The greatest absolute value; not meaningful where there is a NaN.
double largestEntry(const glm::dmat3 &matrix)
{
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            largest = std::max(largest, std::abs(matrix[column][row]));
        }
    }
    return largest;
}

/// Whether no row and no column has two entries: an unequal scale, with axes exchanged or mirrored.
bool isPermutedDiagonal(const glm::dmat3 &matrix)
{
    for (int i = 0; i < 3; ++i) {
        int inColumn = 0;
        int inRow = 0;
        for (int j = 0; j < 3; ++j) {
            inColumn += matrix[i][j] != 0.0 ? 1 : 0;
            inRow += matrix[j][i] != 0.0 ? 1 : 0;
        }
        if (inColumn > 1 || inRow > 1) {
            return false;
        }
    }
    return true;
}

/// The columns of a matrix, each times the power of two that brings its largest entry to [0.5, 1); exact but where
/// entries of one column differ by 10^300.
struct ScaledColumns {
    glm::dmat3 matrix;
    int exponents[3];

    explicit ScaledColumns(const glm::dmat3 &from)
    {
        for (int column = 0; column < 3; ++column) {
            const glm::dvec3 size = glm::abs(from[column]);
            (void)std::frexp(std::max({size.x, size.y, size.z}), &exponents[column]);
            for (int row = 0; row < 3; ++row) {
                matrix[column][row] = std::ldexp(from[column][row], -exponents[column]);
            }
        }
    }

    /// 0 where its rounding may have made it.
    [[nodiscard]] double determinant() const
    {
        const glm::dvec3 &a = matrix[0];
        const glm::dvec3 &b = matrix[1];
        const glm::dvec3 &c = matrix[2];
        const double value = glm::dot(a, glm::cross(b, c));
        // Six products of three numbers, each rounded twice, and their sums.
        const glm::dvec3 sizes(std::abs(b.y * c.z) + std::abs(b.z * c.y), std::abs(b.z * c.x) + std::abs(b.x * c.z),
                               std::abs(b.x * c.y) + std::abs(b.y * c.x));
        const double error = 8.0 * std::numeric_limits<double>::epsilon() * glm::dot(glm::abs(a), sizes) + 1e-300;
        return std::abs(value) > error ? value : 0.0;
    }
};

}

std::size_t AffineMapHash::operator()(const AffineMap &map) const
{
    std::uint64_t hash = 0;
    const auto mix = [&](const glm::dvec3 &numbers) {
        for (int i = 0; i < 3; ++i) {
            hash = (hash ^ std::hash<double>{}(numbers[i])) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 29;
        }
    };
    mix(map.linear[0]);
    mix(map.linear[1]);
    mix(map.linear[2]);
    mix(map.translation);
    return hash;
}

AffineMap mapFromParts(const glm::dvec3 &position, const glm::dvec3 &rotation, const glm::dvec3 &scale)
{
    glm::dmat3 linear = rotationFromDegrees(rotation);
    for (int column = 0; column < 3; ++column) {
        linear[column] *= scale[column];
    }
    return {linear, position};
}

double operatorNorm(const glm::dmat3 &matrix)
{
    // Exact where it can be: a margin on moves alone would grow with the depth.
    if (isPermutedDiagonal(matrix)) {
        return largestEntry(matrix);
    }

    // Rescaled first, so that squares neither overflow nor vanish.
    const double scale = largestEntry(matrix);
    if (scale == 0.0 || !std::isfinite(scale)) {
        return scale;
    }
    const glm::dmat3 scaled = matrix / scale;
    const double squared = largestEigenvalue(glm::transpose(scaled) * scaled);
    return scale * std::sqrt(squared) * (1.0 + 1e-14);
}

double frobeniusNorm(const glm::dmat3 &matrix)
{
    return std::sqrt(glm::dot(matrix[0], matrix[0]) + glm::dot(matrix[1], matrix[1]) + glm::dot(matrix[2], matrix[2]));
}

bool isSimilarity(const glm::dmat3 &matrix)
{
    const double scale = largestEntry(matrix);
    if (scale == 0.0 || !std::isfinite(scale)) {
        return false;
    }
    const glm::dmat3 scaled = matrix / scale;
    const glm::dmat3 gram = glm::transpose(scaled) * scaled;
    const double square = gram[0][0];
    return largestEntry(gram - glm::dmat3(square)) <= 1e-12 * square;
}

int determinantSign(const glm::dmat3 &matrix)
{
    const double determinant = ScaledColumns(matrix).determinant();
    return determinant > 0.0 ? 1 : determinant < 0.0 ? -1 : 0;
}

std::optional<AffineMap> inverse(const AffineMap &map)
{
    const ScaledColumns columns(map.linear);
    const double determinant = columns.determinant();
    if (determinant == 0.0) {
        return std::nullopt;
    }
    AffineMap result;
    bool isFinite = true;
    for (int row = 0; row < 3; ++row) {
        const glm::dvec3 normal =
            glm::cross(columns.matrix[(row + 1) % 3], columns.matrix[(row + 2) % 3]) / determinant;
        for (int column = 0; column < 3; ++column) {
            result.linear[column][row] = std::ldexp(normal[column], -columns.exponents[row]);
        }
        double moved = 0.0;
        for (int column = 0; column < 3; ++column) {
            moved -= result.linear[column][row] * map.translation[column];
        }
        result.translation[row] = moved;
        isFinite = isFinite && std::isfinite(moved); // which it is not where an entry is infinite
    }
    return isFinite ? std::optional(result) : std::nullopt;
}

}
