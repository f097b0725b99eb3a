// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <rapidcheck.h>

#include "core/geometry/affinemap.h"

/// Numbers of every size, and the same arithmetic in 100 digits: the oracles of the geometry tests.
namespace romanesco::test {

using Real = boost::multiprecision::cpp_bin_float_100;
using RealVector = std::array<Real, 3>;

/// ±[0.1, 1)·10^e with e between the two, and now and then 0.
inline rc::Gen<double> wildNumber(int leastExponent = -150, int greatestExponent = 150)
{
    return rc::gen::apply(
        [](int digits, int exponent, bool isNegative) {
            const double size = digits * 1e-9 * std::pow(10.0, exponent);
            return digits % 17 == 0 ? 0.0 : isNegative ? -size : size;
        },
        rc::gen::resize(1'000'000'000, rc::gen::inRange(100'000'000, 1'000'000'000)),
        rc::gen::inRange(leastExponent, greatestExponent), rc::gen::arbitrary<bool>());
}

inline rc::Gen<glm::dvec3> wildVector(int least = -150, int greatest = 150)
{
    return rc::gen::construct<glm::dvec3>(wildNumber(least, greatest), wildNumber(least, greatest),
                                          wildNumber(least, greatest));
}

inline rc::Gen<glm::dmat3> wildMatrix(int least = -150, int greatest = 150)
{
    return rc::gen::construct<glm::dmat3>(wildVector(least, greatest), wildVector(least, greatest),
                                          wildVector(least, greatest));
}

inline RealVector exact(const glm::dvec3 &v)
{
    return {Real(v.x), Real(v.y), Real(v.z)};
}

inline RealVector applied(const AffineMap &map, const RealVector &p)
{
    RealVector result;
    for (int row = 0; row < 3; ++row) {
        result[static_cast<std::size_t>(row)] = Real(map.translation[row]) + Real(map.linear[0][row]) * p[0]
            + Real(map.linear[1][row]) * p[1] + Real(map.linear[2][row]) * p[2];
    }
    return result;
}

inline Real distance(const RealVector &a, const RealVector &b)
{
    Real sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sqrt(sum);
}

}
