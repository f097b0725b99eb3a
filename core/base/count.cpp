// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "count.h"

#include <cmath>
#include <limits>

namespace romanesco {

namespace mp = boost::multiprecision;

namespace {

using Integer = mp::cpp_int;

/// floor(10,000 · log2(10)): an integer whose top bit lies below this one has at most 10,000 digits.
constexpr unsigned exactBits = 33'219;

/// Whether an integer has more than the digits that are kept. Only near the limit is it compared with the limit itself.
bool isTooLong(const Integer &value)
{
    const unsigned top = value.is_zero() ? 0 : static_cast<unsigned>(mp::msb(value));
    if (top != exactBits) {
        return top > exactBits;
    }
    static const Integer limit = mp::pow(Integer(10), Count::maximumExactDigits);
    return value >= limit;
}

}

Count::Count(std::uint64_t value)
    : m_value(Integer(value))
{
}

bool Count::isExact() const
{
    return std::holds_alternative<Integer>(m_value);
}

bool Count::isZero() const
{
    const Integer *exact = std::get_if<Integer>(&m_value);
    return exact && exact->is_zero();
}

std::optional<std::uint64_t> Count::toInteger() const
{
    const Integer *exact = std::get_if<Integer>(&m_value);
    if (!exact || *exact > std::numeric_limits<std::uint64_t>::max()) {
        return std::nullopt;
    }
    return static_cast<std::uint64_t>(*exact);
}

void Count::settle()
{
    if (isTooLong(std::get<Integer>(m_value))) {
        m_value = approximate();
    }
}

void Count::assignNormalised(Mantissa mantissa, Integer exponent)
{
    while (mantissa >= 10) {
        mantissa /= 10;
        ++exponent;
    }
    m_value = Approximate{std::move(mantissa), std::move(exponent)};
}

Count::Approximate Count::approximate() const
{
    if (const auto *already = std::get_if<Approximate>(&m_value)) {
        return *already;
    }
    const Integer &exact = std::get<Integer>(m_value);
    const Integer exponent = exact.is_zero() ? Integer(0) : Integer(exact.str().size() - 1);
    return {Mantissa(exact) / mp::pow(Mantissa(10), static_cast<int>(exponent)), exponent};
}

Count &Count::operator+=(const Count &other)
{
    if (isExact() && other.isExact()) {
        std::get<Integer>(m_value) += std::get<Integer>(other.m_value);
        settle();
        return *this;
    }
    if (isZero() || other.isZero()) {
        return isZero() ? *this = other : *this;
    }
    Approximate large = approximate();
    Approximate small = other.approximate();
    if (large.exponent < small.exponent) {
        std::swap(large, small);
    }

    // What is 60 decimal places below the larger number is below its last digit.
    const Integer shift = large.exponent - small.exponent;
    if (shift <= 60) {
        large.mantissa += small.mantissa / mp::pow(Mantissa(10), static_cast<int>(shift));
    }
    assignNormalised(large.mantissa, large.exponent);
    return *this;
}

Count &Count::operator*=(const Count &other)
{
    if (isZero() || other.isZero()) {
        return *this = Count(0);
    }
    if (isExact() && other.isExact()) {
        std::get<Integer>(m_value) *= std::get<Integer>(other.m_value);
        settle();
        return *this;
    }
    const Approximate a = approximate();
    const Approximate b = other.approximate();
    assignNormalised(a.mantissa * b.mantissa, a.exponent + b.exponent);
    return *this;
}

std::string Count::toString() const
{
    if (const auto *exact = std::get_if<Integer>(&m_value)) {
        return exact->str();
    }
    const auto &[mantissa, exponent] = std::get<Approximate>(m_value);
    Integer hundredths(mp::round(mantissa * 100));
    Integer shown = exponent;
    if (hundredths >= 1000) {
        hundredths /= 10;
        ++shown;
    }
    const std::string digits = hundredths.str();
    return "~" + digits.substr(0, 1) + "." + digits.substr(1) + "e" + shown.str();
}

double Count::log10() const
{
    if (isZero()) {
        return -std::numeric_limits<double>::infinity();
    }
    const auto [mantissa, exponent] = approximate();
    return static_cast<double>(mp::log10(mantissa)) + static_cast<double>(exponent);
}

Count power(Count base, std::uint64_t exponent)
{
    Count result(1);
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) {
            result *= base;
        }
        if (exponent > 1) {
            base *= base;
        }
    }
    return result;
}

}
