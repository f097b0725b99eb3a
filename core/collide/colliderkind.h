// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>

namespace romanesco {

/// The ways to find the nearest point of a surface; each but Approximate is a class of that name.
enum class ColliderKind {
    Exact,
    Approximate, ///< ExactCollider with an excess
    Greedy,
    Octree,
    Bvh,
    Simple,
};

/// As people name them, in the order of their numbers.
inline constexpr std::array<std::string_view, 6> colliderNames{"exact",  "approximate", "greedy",
                                                               "octree", "bvh",         "simple"};

[[nodiscard]] inline std::optional<ColliderKind> colliderKind(std::string_view name)
{
    const auto found = std::ranges::find(colliderNames, name);
    return found == colliderNames.end() ? std::nullopt
                                        : std::optional(static_cast<ColliderKind>(found - colliderNames.begin()));
}

}
