// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "affinemap.h"

namespace romanesco {

/// x ↦ translation + rotation·(scale ∘ x): what most other programs have in place of affine maps.
struct Trs {
    glm::dvec3 translation{0.0};
    /// Of length 1.
    glm::dquat rotation{1.0, 0.0, 0.0, 0.0};
    /// Not negative but for z, which takes all of a mirror.
    glm::dvec3 scale{1.0};
};

/// The same map in three parts; nothing where it shears: where the images of two axes are off a right angle by more than
/// 1e-6, which is all that floats tell. Flat maps have parts too.
[[nodiscard]] std::optional<Trs> trsOf(const AffineMap &map);

}
