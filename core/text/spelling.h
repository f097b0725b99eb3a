// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string_view>

namespace romanesco {

/// How many slips lead from one word to another: a byte too many, too few or wrong, or two neighbours in the wrong order,
/// each byte in one of them (the optimal string alignment distance). Cost: the product of the lengths.
[[nodiscard]] std::size_t slipsBetween(std::string_view one, std::string_view other);

/// How many slips may have made a word of another, so that the other is worth naming: a third of its length.
[[nodiscard]] constexpr std::size_t mostSlips(std::string_view word)
{
    return (word.size() + 1) / 3;
}

}
