// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "core/geometry/affinemap.h"

namespace romanesco {

/// Digits enough to tell copies of a thousand levels apart in the world's coordinates.
using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<700>, boost::multiprecision::et_off>;

template<typename T>
using VectorOf = std::array<T, 3>;

/// An affine map with all sums and products in numbers of one kind.
template<typename T>
struct WorldMap {
    std::array<VectorOf<T>, 3> columns{VectorOf<T>{1, 0, 0}, VectorOf<T>{0, 1, 0}, VectorOf<T>{0, 0, 1}};
    VectorOf<T> translation{0, 0, 0};

    [[nodiscard]] VectorOf<T> turned(const glm::dvec3 &v) const
    {
        VectorOf<T> result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = columns[0][i] * T(v.x) + columns[1][i] * T(v.y) + columns[2][i] * T(v.z);
        }
        return result;
    }

    [[nodiscard]] VectorOf<T> operator()(const glm::dvec3 &point) const
    {
        VectorOf<T> result = turned(point);
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] += translation[i];
        }
        return result;
    }

    /// Inner first.
    [[nodiscard]] WorldMap operator*(const AffineMap &inner) const
    {
        return {{turned(inner.linear[0]), turned(inner.linear[1]), turned(inner.linear[2])},
                (*this)(inner.translation)};
    }
};

}
