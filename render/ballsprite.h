// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <memory>

#include "core/scene/surroundings.h"

namespace romanesco {

/// A ball as it is seen.
struct BallSprite {
    glm::dvec3 centre{0.0};
    double radius = 1.0;
    /// sRGB, 0 to 1.
    std::array<float, 3> colour{1.0f, 1.0f, 1.0f};
    /// What centre and radius are counted from; null for the world.
    std::shared_ptr<const Surroundings> place = {};
};

}
