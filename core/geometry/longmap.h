// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>

#include <boost/multiprecision/cpp_int.hpp>

#include "affinemap.h"

namespace romanesco {

/// An affine map in fixed point, for differences of places that agree in more digits than a double has: twelve whole
/// numbers of a unit of 2^-bits. Values only; memory and the cost of each number follow how large it is in that unit.
class LongMap
{
public:
    /// Without a translation; the numbers are below 2^-bits off, exact where they are multiples of it.
    LongMap(const glm::dmat3 &linear, unsigned bits);

    /// outer * inner applies inner first. The inner one is exact; of each of the 36 products less than 2^-bits is cut off.
    friend LongMap operator*(const LongMap &outer, const AffineMap &inner);

    /// Both translations less that of `origin`, whose bits are as many.
    void moveTo(const LongMap &origin);
    void moveToOrigin();

    /// As near as a double comes, divided by 2^exponent. What a double does not hold becomes infinite or 0.
    [[nodiscard]] AffineMap dividedBy(double exponent) const;

private:
    using Integer = boost::multiprecision::cpp_int;
    using Vector = std::array<Integer, 3>;

    LongMap() = default;

    std::array<Vector, 3> m_columns;
    Vector m_translation;
    unsigned m_bits = 0;
};

}
