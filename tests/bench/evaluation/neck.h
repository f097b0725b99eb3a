// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/vec3.hpp>

#include "core/collide/collider.h"

namespace romanesco::bench {

/// The narrowest part of the widest way between places.
struct Neck {
    /// Of the largest ball that gets through on the way that was found; a wider way may be missed by as much as `missed`.
    double radius = 0.0;
    double missed = 0.0;
    glm::dvec3 centre{0.0};
};

/// Where ways lead that never come above a height: within a margin round the box of both points.
struct Ways {
    glm::dvec3 from{0.0};
    glm::dvec3 to{0.0};
    double highest = 0.0;
    double margin = 0.0;
};

/// The ball's centre goes from one point to the other, or to anything that is as low. On a grid, which becomes finer where
/// the way is narrowest, down to a thousandth of the margin. Cost: some hundred thousand queries.
[[nodiscard]] Neck widestWayTo(const Collider &exact, const Ways &ways);
[[nodiscard]] Neck widestWayDown(const Collider &exact, const Ways &ways);

}
