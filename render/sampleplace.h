// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cmath>

namespace romanesco {

/// Where sample i of n lies in the pixel, from its centre, in pixels: the R2 sequence (Roberts 2018), which covers the
/// square evenly for every n. The only sample of one is the centre itself.
inline std::array<double, 2> samplePlace(int i, int n)
{
    if (n == 1) {
        return {0.0, 0.0};
    }
    constexpr double a = 0.7548776662466927;
    constexpr double b = 0.5698402909980532;
    const auto fraction = [](double x) { return x - std::floor(x); };
    return {fraction(0.5 + a * i) - 0.5, fraction(0.5 + b * i) - 0.5};
}

}
