// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "count.h"

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

namespace romanesco {

namespace mp = boost::multiprecision;

namespace {

using Integer = mp::cpp_int;
using Mantissa = mp::cpp_bin_float_50;

/// mantissa * 10^exponent, with the mantissa in [1, 10).
struct Approximate {
    Mantissa mantissa;
    Integer exponent;
    bool operator==(const Approximate &) const = default;
};

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

Approximate normalised(Mantissa mantissa, Integer exponent)
{
    while (mantissa >= 10) {
        mantissa /= 10;
        ++exponent;
    }
    return {std::move(mantissa), std::move(exponent)};
}

Approximate rounded(const Integer &exact)
{
    const Integer exponent = exact.is_zero() ? Integer(0) : Integer(exact.str().size() - 1);
    return {Mantissa(exact) / mp::pow(Mantissa(10), static_cast<int>(exponent)), exponent};
}

Approximate sum(Approximate large, Approximate small)
{
    if (large.exponent < small.exponent) {
        std::swap(large, small);
    }

    // What is 60 decimal places below the larger number is below its last digit.
    const Integer shift = large.exponent - small.exponent;
    if (shift <= 60) {
        large.mantissa += small.mantissa / mp::pow(Mantissa(10), static_cast<int>(shift));
    }
    return normalised(large.mantissa, large.exponent);
}

}

struct Count::Value : std::variant<Integer, Approximate> {
    using variant::variant;

    [[nodiscard]] static std::shared_ptr<const Value> of(Integer integer)
    {
        if (isTooLong(integer)) {
            return std::make_shared<const Value>(rounded(integer));
        }
        return std::make_shared<const Value>(std::move(integer));
    }
    [[nodiscard]] static std::shared_ptr<const Value> of(Approximate approximate)
    {
        return std::make_shared<const Value>(std::move(approximate));
    }

    /// None where the value is approximate.
    [[nodiscard]] const Integer *exact() const { return std::get_if<Integer>(this); }
    [[nodiscard]] Approximate approximate() const { return exact() ? rounded(*exact()) : std::get<Approximate>(*this); }
};

Count::Count(std::uint64_t value)
    : m_value(Value::of(Integer(value)))
{
}

bool Count::isExact() const
{
    return m_value->exact();
}

bool Count::isZero() const
{
    return isExact() && m_value->exact()->is_zero();
}

std::optional<std::uint64_t> Count::toInteger() const
{
    const Integer *exact = m_value->exact();
    if (!exact || *exact > std::numeric_limits<std::uint64_t>::max()) {
        return std::nullopt;
    }
    return static_cast<std::uint64_t>(*exact);
}

Count &Count::operator+=(const Count &other)
{
    if (isExact() && other.isExact()) {
        m_value = Value::of(*m_value->exact() + *other.m_value->exact());
    } else if (isZero()) {
        *this = other;
    } else if (!other.isZero()) {
        m_value = Value::of(sum(m_value->approximate(), other.m_value->approximate()));
    }
    return *this;
}

Count &Count::operator*=(const Count &other)
{
    if (isZero() || other.isZero()) {
        *this = Count(0);
    } else if (isExact() && other.isExact()) {
        m_value = Value::of(*m_value->exact() * *other.m_value->exact());
    } else {
        const Approximate a = m_value->approximate();
        const Approximate b = other.m_value->approximate();
        m_value = Value::of(normalised(a.mantissa * b.mantissa, a.exponent + b.exponent));
    }
    return *this;
}

bool operator==(const Count &a, const Count &b)
{
    return *a.m_value == *b.m_value;
}

std::string Count::toString() const
{
    if (const Integer *exact = m_value->exact()) {
        return exact->str();
    }
    const auto [mantissa, exponent] = m_value->approximate();
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
    const auto [mantissa, exponent] = m_value->approximate();
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
