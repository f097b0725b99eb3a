// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "writtennumber.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/formats/numbers.h"

namespace romanesco {

namespace {

constexpr int mostDecimals = 15;

/// A mantissa in plain digits, rounded correctly to so many decimals.
std::string fixed(double value, int decimals)
{
    std::array<char, 400> digits{};
    const auto [end, error] =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
    std::string text(digits.data(), error == std::errc() ? end : digits.data());
    if (text.starts_with('-') && text.find_first_of("123456789") == text.npos) {
        text.erase(0, 1); // no -0
    }
    return text;
}

TextEdit written(const WrittenNumber &number, double mantissa)
{
    std::string text = fixed(mantissa, number.decimals);
    if (number.hasPlus && !text.starts_with('-')) {
        text.insert(0, 1, '+');
    }
    return {number.range, text + number.exponentText};
}

double mantissaOf(const WrittenNumber &number, double value)
{
    // dividing by a power of ten is right where multiplying by its inverse is not
    return number.exponent < 0 ? value * std::pow(10.0, -number.exponent) : value / std::pow(10.0, number.exponent);
}

}

std::optional<WrittenNumber> writtenNumber(std::string_view text, SourceRange range)
{
    const std::string_view words = text.substr(range.begin, range.length());
    const auto [value, status] = numberFromText(words);
    if (status == NumberStatus::Malformed || status == NumberStatus::Overflow) {
        return std::nullopt;
    }
    WrittenNumber number;
    number.range = range;
    number.value = value;
    const std::size_t e = std::min(words.find_first_of("eE"), words.size());
    const std::string_view mantissa = words.substr(0, e);
    const std::size_t dot = mantissa.find('.');
    number.decimals = dot == mantissa.npos ? 0 : static_cast<int>(mantissa.size() - dot - 1);
    number.hasPlus = words.starts_with('+');
    number.exponentText = words.substr(e);
    std::string_view digits = words.substr(std::min(e + 1, words.size()));
    digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
    std::from_chars(digits.data(), digits.data() + digits.size(), number.exponent);
    const bool isUsual = number.decimals <= mostDecimals && std::abs(number.exponent) <= 300;
    return isUsual ? std::optional(number) : std::nullopt;
}

TextEdit withValue(const WrittenNumber &number, double value)
{
    return written(number, mantissaOf(number, std::isfinite(value) ? value : number.value));
}

TextEdit stepped(WrittenNumber number, int steps, int finer)
{
    const double mantissa = mantissaOf(number, number.value);
    number.decimals = std::min(number.decimals + finer, std::max(number.decimals, mostDecimals));
    const double step = std::pow(10.0, -number.decimals);
    return written(number, mantissa + steps * step);
}

}
