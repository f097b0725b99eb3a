// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace romanesco {

static_assert(std::endian::native == std::endian::little, "binary formats are written as the machine has numbers");

/// Puts the bytes of a number, least significant first, and gives their end.
template<typename Number>
[[nodiscard]] char *putBinary(char *to, Number number)
{
    std::memcpy(to, &number, sizeof(number));
    return to + sizeof(number);
}

/// The corners of a face in the order in which it is written: the other way round for a mirrored copy.
[[nodiscard]] constexpr std::array<std::size_t, 3> cornerOrder(bool isMirrored)
{
    return isMirrored ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
}

}
