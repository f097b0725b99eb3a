// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cmath>

#include <glm/vec3.hpp>

#include "box.h"

/// How large coordinates are: what bounds of rounding are counted in.
namespace romanesco {

[[nodiscard]] inline double sumOfSizes(const glm::dvec3 &v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

[[nodiscard]] inline double greatestSize(const glm::dvec3 &v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// That of a box's corner where it is greatest.
[[nodiscard]] inline double sumOfSizes(const Box &box)
{
    return sumOfSizes(glm::max(glm::abs(box.least), glm::abs(box.greatest)));
}

}
