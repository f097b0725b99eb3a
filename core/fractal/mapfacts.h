// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "core/geometry/affinemap.h"

namespace romanesco {

/// What is kept of a single map beside the map: no chain of maps has an inverse or a sign of its own, since they are
/// made of these.
struct MapFacts {
    /// operatorNorm() of the linear part. Of a similarity, its scale.
    double norm = 1.0;
    bool isSimilarity = true;
    /// determinantSign() of the linear part: -1 mirrors, 0 is flat.
    int sign = 1;
    std::optional<AffineMap> inverse = AffineMap{};
};

[[nodiscard]] inline MapFacts factsOf(const AffineMap &map)
{
    return {operatorNorm(map.linear), isSimilarity(map.linear), determinantSign(map.linear), inverse(map)};
}

}
