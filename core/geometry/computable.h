// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// From the origin: so far anything may reach that distances are taken to. 100 times its square is a number.
constexpr double farthestReach = 1e153;

/// Whether what reaches so far is near enough to the origin. False for what is no number itself.
[[nodiscard]] inline bool isComputable(const glm::dvec3 &place, double radius = 0.0)
{
    return glm::length(place) + radius <= farthestReach;
}

}
