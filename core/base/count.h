// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace romanesco {

/// A natural number of any size: exact up to 10,000 decimal digits, beyond that a mantissa of 50 digits and an
/// exponent of ten. Sums and products of exact values are exact while they fit; once a value is approximate, so is
/// all that is made of it. Values only; thread-safe as values are. A copy costs nothing: what is large is shared, and never
/// changed.
class Count
{
public:
    static constexpr unsigned maximumExactDigits = 10'000;

    Count(std::uint64_t value = 0);

    [[nodiscard]] bool isExact() const;
    [[nodiscard]] bool isZero() const;

    /// Decimal digits, or "~8.81e646456992" (three significant digits, rounded) where the value is not exact.
    [[nodiscard]] std::string toString() const;

    /// The value where it is exact and fits.
    [[nodiscard]] std::optional<std::uint64_t> toInteger() const;

    /// The decimal logarithm, to double precision; -inf of zero.
    [[nodiscard]] double log10() const;

    Count &operator+=(const Count &other);
    Count &operator*=(const Count &other);
    friend Count operator+(Count a, const Count &b) { return a += b; }
    friend Count operator*(Count a, const Count &b) { return a *= b; }
    friend bool operator==(const Count &a, const Count &b);

private:
    /// Its types are large headers, which who counts need not read.
    struct Value;

    std::shared_ptr<const Value> m_value;
};

/// base to the power of exponent, by squaring: at most 128 products.
[[nodiscard]] Count power(Count base, std::uint64_t exponent);

}
