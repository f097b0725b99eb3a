// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <format>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/text/nametable.h"

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

/// The number of a name, where the text has it anywhere. Cost linear in the number of names.
[[nodiscard]] inline std::optional<NameId> findName(const NameTable &names, std::string_view text)
{
    for (NameId id = 0; id < names.size(); ++id) {
        if (names[id] == text) {
            return id;
        }
    }
    return std::nullopt;
}

}
