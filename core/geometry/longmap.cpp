// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "longmap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace romanesco {

namespace {

using Integer = boost::multiprecision::cpp_int;

/// A double is a whole number times a power of two.
struct Parts {
    std::int64_t number = 0;
    int exponent = 0;
};

Parts partsOf(double x)
{
    assert(std::isfinite(x) && "maps of a text are numbers");
    constexpr int digits = std::numeric_limits<double>::digits;
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return {static_cast<std::int64_t>(std::ldexp(fraction, digits)), exponent - digits};
}

void shift(Integer &number, int exponent)
{
    if (exponent >= 0) {
        number <<= exponent;
    } else {
        number >>= -exponent;
    }
}

/// term is room for work: the numbers are longer than what is held without the heap.
void addProduct(Integer &sum, const Integer &a, double x, Integer &term)
{
    if (x == 0.0 || a.is_zero()) {
        return;
    }
    const Parts parts = partsOf(x);
    term = a;
    term *= parts.number;
    shift(term, parts.exponent);
    sum += term;
}

double divided(const Integer &number, int exponent)
{
    constexpr int limbBits = static_cast<int>(sizeof(boost::multiprecision::limb_type) * 8);
    const auto &all = number.backend();
    const auto count = static_cast<int>(all.size());
    // three limbs hold more than a double does
    const int last = std::max(count - 3, 0);
    double value = 0.0;
    for (int i = count; i-- > last;) {
        value = std::ldexp(value, limbBits) + static_cast<double>(all.limbs()[i]);
    }
    const double size = std::ldexp(value, last * limbBits - exponent);
    return number.sign() < 0 ? -size : size;
}

}

LongMap::LongMap(const glm::dmat3 &linear, unsigned bits)
    : m_bits(bits)
{
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const Parts parts = partsOf(linear[column][row]);
            Integer &number = m_columns[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
            number = parts.number;
            shift(number, parts.exponent + static_cast<int>(bits));
        }
    }
}

LongMap operator*(const LongMap &outer, const AffineMap &inner)
{
    LongMap product;
    product.m_bits = outer.m_bits;
    product.m_translation = outer.m_translation;
    Integer term;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Integer &factor = outer.m_columns[i][row];
            const auto axis = static_cast<glm::length_t>(i);
            addProduct(product.m_translation[row], factor, inner.translation[axis], term);
            for (std::size_t column = 0; column < 3; ++column) {
                const double x = inner.linear[static_cast<glm::length_t>(column)][axis];
                addProduct(product.m_columns[column][row], factor, x, term);
            }
        }
    }
    return product;
}

void LongMap::moveTo(const LongMap &origin)
{
    assert(m_bits == origin.m_bits && "the units are the same");
    for (std::size_t i = 0; i < 3; ++i) {
        m_translation[i] -= origin.m_translation[i];
    }
}

void LongMap::moveToOrigin()
{
    m_translation = {};
}

AffineMap LongMap::dividedBy(double exponent) const
{
    const int whole = static_cast<int>(std::floor(exponent));
    const double rest = std::exp2(whole - exponent);
    const int down = static_cast<int>(m_bits) + whole;
    const auto toDouble = [&](const Vector &v) {
        return rest * glm::dvec3(divided(v[0], down), divided(v[1], down), divided(v[2], down));
    };
    return {{toDouble(m_columns[0]), toDouble(m_columns[1]), toDouble(m_columns[2])}, toDouble(m_translation)};
}

}
