// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "spread.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <ctime>

namespace romanesco {

double quantile(std::vector<double> values, double share)
{
    assert(!values.empty() && share > 0.0 && share <= 1.0);
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
    std::ranges::nth_element(values, values.begin() + rank);
    return values[static_cast<std::size_t>(rank)];
}

Spread spreadOf(std::vector<double> values)
{
    return {quantile(values, 0.5), quantile(values, 0.25), quantile(values, 0.75)};
}

double threadSeconds()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}
