// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "numbers.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>

namespace romanesco {

namespace {

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Whether a well-formed number that no double holds is too large rather than too small: where its first significant
/// digit stands, moved by the exponent. An exponent that overflows counts as ±10^9.
bool isLarge(std::string_view digits)
{
    const std::size_t e = std::min(digits.find_first_of("eE"), digits.size());
    const std::size_t point = std::min(digits.substr(0, e).find('.'), e);
    const std::size_t significant = digits.find_first_of("123456789");
    long long magnitude = significant < point ? static_cast<long long>(point - significant)
                                              : -static_cast<long long>(significant - point) + 1;
    if (e < digits.size()) {
        std::string_view exponent = digits.substr(e + 1);
        const bool isNegative = exponent.starts_with('-');
        exponent.remove_prefix(isNegative || exponent.starts_with('+') ? 1 : 0);
        const auto value = static_cast<long long>(std::min<std::uint64_t>(*wholeFromText(exponent), 1'000'000'000));
        magnitude += isNegative ? -value : value;
    }
    return magnitude > 0;
}

}

ParsedNumber numberFromText(std::string_view text)
{
    std::string_view digits = text;
    const bool isNegative = digits.starts_with('-');
    if (isNegative || digits.starts_with('+')) {
        digits.remove_prefix(1);
    }
    // from_chars also reads "inf", "nan" and a second sign, which are no numbers here.
    if (digits.empty() || (!isDigit(digits[0]) && digits[0] != '.')) {
        return {};
    }
    double value = 0.0;
    const char *end = digits.data() + digits.size();
    const auto [stopped, status] = std::from_chars(digits.data(), end, value);
    if (status == std::errc::invalid_argument || stopped != end) {
        return {};
    }
    if (status == std::errc::result_out_of_range) {
        return {0.0, isLarge(digits) ? NumberStatus::Overflow : NumberStatus::Underflow};
    }
    return {isNegative ? -value : value, NumberStatus::Good};
}

std::optional<std::uint64_t> wholeFromText(std::string_view text)
{
    if (text.empty() || !std::ranges::all_of(text, isDigit)) {
        return std::nullopt;
    }
    std::uint64_t value = 0;
    const auto [stopped, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    return status == std::errc::result_out_of_range ? std::numeric_limits<std::uint64_t>::max() : value;
}

}
