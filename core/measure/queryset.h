// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <string_view>

namespace romanesco {

/// Where a surface is asked from.
enum class QuerySet {
    Uniform, ///< anywhere in 1.5 times its box
    Near,    ///< from 0.1 to 5 % of the box's diagonal off a face, along its normal
    Pocket,  ///< in 0.9 of the box, moved away from the surface
    Balls,   ///< as balls ask that fall on it
};

/// In the order of their numbers.
inline constexpr std::array<std::string_view, 4> querySetNames{"uniform", "near", "pocket", "balls"};

[[nodiscard]] constexpr std::string_view nameOf(QuerySet set)
{
    return querySetNames[static_cast<std::size_t>(set)];
}

}
