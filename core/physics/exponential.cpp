// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "exponential.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace romanesco {

double exponential(double x)
{
    constexpr double least = -708.0;
    constexpr double greatest = 709.0;
    if (!(x >= least)) {
        return std::isnan(x) ? x : 0.0;
    }
    if (x > greatest) {
        return std::numeric_limits<double>::infinity();
    }
    // x = k·ln 2 + f, with ln 2 in two parts, the first so short that its multiples are exact
    constexpr double lnHigh = 0x1.62e42feep-1;
    constexpr double lnLow = 0x1.a39ef35793c76p-33;
    const double k = std::nearbyint(x / std::numbers::ln2);
    const double f = (x - k * lnHigh) - k * lnLow;
    // Taylor's series: |f| is below 0.347, so what is left out is below 2^-60
    constexpr int terms = 14;
    double sum = 1.0;
    for (int i = terms; i > 0; --i) {
        sum = 1.0 + sum * f / i;
    }
    return std::ldexp(sum, static_cast<int>(k));
}

}
