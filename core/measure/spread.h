// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

namespace romanesco {

/// What was measured several times: half of it lies between the quartiles.
struct Spread {
    double median = 0.0;
    double lowerQuartile = 0.0;
    double upperQuartile = 0.0;
};

/// Of one value or more.
[[nodiscard]] Spread spreadOf(std::vector<double> values);

/// The value that so large a share of all, above 0 and up to 1, does not exceed. Of one value or more.
[[nodiscard]] double quantile(std::vector<double> values, double share);

/// Seconds that the calling thread has worked, so that what else the machine does counts little.
[[nodiscard]] double threadSeconds();

}
