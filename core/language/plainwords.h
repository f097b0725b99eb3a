// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <format>
#include <string>

#include <glm/vec3.hpp>

namespace romanesco {

/// Numbers as people read them in a tool tip: six significant digits, no -0.
[[nodiscard]] inline std::string plainWords(double value)
{
    return std::format("{:.6g}", value + 0.0);
}

/// 1 1 -2
[[nodiscard]] inline std::string plainWords(const glm::dvec3 &value)
{
    return std::format("{} {} {}", plainWords(value.x), plainWords(value.y), plainWords(value.z));
}

}
