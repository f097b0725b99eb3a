// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace romanesco {

/// A JSON string, quotes included. Bytes that are no UTF-8 become U+FFFD each: JSON has no others.
[[nodiscard]] std::string jsonString(std::string_view text);

/// The shortest digits that read back as the same number; finite.
[[nodiscard]] std::string jsonNumber(double value);

/// "[1,2,3]".
[[nodiscard]] std::string jsonNumbers(std::span<const double> values);

/// "[a,b]" of texts that are JSON already.
[[nodiscard]] std::string jsonArray(std::span<const std::string> values);

}
