// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/vec3.hpp>

#include "core/collide/collider.h"

namespace romanesco::bench {

/// The narrowest part of the widest way down from a point.
struct Neck {
    /// Of the largest ball that gets through on the way that was found; a wider way may be missed by as much as `missed`.
    double radius = 0.0;
    double missed = 0.0;
    glm::dvec3 centre{0.0};
};

/// Looks for ways to anything at a height or lower that stay below another height, and within a margin round the point
/// and what is straight below it. On a grid, which becomes finer where the way is narrowest, down to a thousandth of the
/// margin. Cost: some hundred thousand queries.
[[nodiscard]] Neck widestWayDown(const Collider &exact, const glm::dvec3 &from, double lowest, double highest,
                                 double margin);

}
