// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "core/fractal/statetable.h"

namespace romanesco {

/// A node on a way from the world into an item's graph, below the one before.
struct WayLevel {
    /// From the level above; of a root the map is the item's number.
    Step step;
    AffineMap map;
    Positions state;
    /// Round all below, in the node's own frame.
    Sphere bound;
    /// The product of all maps down to here, without its norm.
    glm::dmat3 linear;
    /// Of this level's norm to that above, and the logarithm to base 2 of the product of all of them.
    double ratio = 1.0;
    double exponent = 0.0;
};

}
