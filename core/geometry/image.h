// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

namespace romanesco {

/// What a texture shows: rows from the top, of each pixel red, green, blue in sRGB and opacity, 8 bits each.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;
};

}
