// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "share.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace romanesco {

double Share::value() const
{
    assert(of > 0 && count <= of && "a share is of something");
    return static_cast<double>(count) / static_cast<double>(of);
}

Share::Interval Share::interval() const
{
    constexpr double z = 1.959963984540054; // 97.5 % of a normal distribution are below
    const double n = static_cast<double>(of);
    const double p = value();
    const double scale = 1.0 / (1.0 + z * z / n);
    const double middle = scale * (p + z * z / (2.0 * n));
    const double half = scale * z * std::sqrt(p * (1.0 - p) / n + z * z / (4.0 * n * n));
    // at either end the formula gives 0 or 1 but for rounding
    return {count == 0 ? 0.0 : std::max(middle - half, 0.0), count == of ? 1.0 : std::min(middle + half, 1.0)};
}

}
