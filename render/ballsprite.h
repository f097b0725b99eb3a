// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace romanesco {

/// A ball as it is seen.
struct BallSprite {
    /// In the world.
    glm::dvec3 centre{0.0};
    double radius = 1.0;
    /// sRGB, 0 to 1.
    std::array<float, 3> colour{1.0f, 1.0f, 1.0f};
};

}
