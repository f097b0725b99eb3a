// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>

#include "core/collide/collider.h"

namespace romanesco {

/// What balls fall on.
struct Surface {
    std::shared_ptr<const Collider> collider;
    /// Whether the collider's answers prove that nothing is nearer; else balls may go through the surface.
    bool isProved = true;
    /// The greatest coordinate of the surface, either way: for the rounding.
    double size = 0.0;
    /// Whether the nearest point is found, not only one that is not much farther.
    bool isExact = true;
};

}
