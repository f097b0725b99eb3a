// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace romanesco {

enum class NumberStatus { Good, Underflow, Overflow, Malformed };

struct ParsedNumber {
    double value = 0.0;
    NumberStatus status = NumberStatus::Malformed;
};

/// [+-](D+[.D*] | .D+)[(e|E)[+-]D+], the whole text, correctly rounded, whatever the locale. What is too small for a
/// double is 0 (Underflow); nan, inf and hexadecimal are Malformed.
[[nodiscard]] ParsedNumber numberFromText(std::string_view text);

/// D+, the whole text; what does not fit 64 bits gives the greatest value. Empty where there is anything but digits.
[[nodiscard]] std::optional<std::uint64_t> wholeFromText(std::string_view text);

}
