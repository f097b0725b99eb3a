// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>

namespace romanesco {

/// Told apart by people who see fewer colours too (Okabe and Ito 2008). sRGB.
inline constexpr std::array<std::array<float, 3>, 6> ballColours{{
    {0.90f, 0.62f, 0.00f},
    {0.34f, 0.71f, 0.91f},
    {0.00f, 0.62f, 0.45f},
    {0.94f, 0.89f, 0.26f},
    {0.84f, 0.37f, 0.00f},
    {0.80f, 0.47f, 0.65f},
}};

/// Of a ball by its number: one after another.
[[nodiscard]] inline std::array<float, 3> ballColour(std::uint64_t number)
{
    return ballColours[number % ballColours.size()];
}

}
