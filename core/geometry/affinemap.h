// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// x ↦ linear·x + translation, in left-handed coordinates (x right, y up, z forward) on column vectors.
struct AffineMap {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};

    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3 &point) const { return linear * point + translation; }

    /// outer * inner applies inner first.
    friend AffineMap operator*(const AffineMap &outer, const AffineMap &inner)
    {
        return {outer.linear * inner.linear, outer(inner.translation)};
    }

    /// All twelve numbers equal. (-0 equals 0.)
    bool operator==(const AffineMap &) const = default;
};

struct AffineMapHash {
    [[nodiscard]] std::size_t operator()(const AffineMap &map) const;
};

/// The map position + R(rotation)·(scale ∘ x): scale first, then rotation (degrees), then position.
[[nodiscard]] AffineMap mapFromParts(const glm::dvec3 &position, const glm::dvec3 &rotation, const glm::dvec3 &scale);

/// The operator norm (largest singular value), never below the true value and at most 1e-12 of it above.
[[nodiscard]] double operatorNorm(const glm::dmat3 &matrix);

/// The root of the sum of squares: at least the operator norm but for rounding, at the price of nine products. Not for
/// numbers whose squares are none.
[[nodiscard]] double frobeniusNorm(const glm::dmat3 &matrix);

/// Whether the matrix is a uniform scale times a rotation or reflection, within 1e-12 of its norm.
[[nodiscard]] bool isSimilarity(const glm::dmat3 &matrix);

/// The sign of the determinant: -1 where the matrix mirrors, 1 where not, and 0 where it is flat or its columns are
/// within rounding of a plane. Never the opposite of the true sign, whatever the sizes of the columns.
[[nodiscard]] int determinantSign(const glm::dmat3 &matrix);

/// The map that takes back what this one does; nothing where determinantSign() is 0 or a double does not hold it.
/// Its error grows with the condition of the matrix, columns brought to one size.
[[nodiscard]] std::optional<AffineMap> inverse(const AffineMap &map);

}
