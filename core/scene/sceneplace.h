// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/fractal/step.h"

namespace romanesco {

/// A node of an item's graph: the way down to it from the item's root.
struct ScenePlace {
    std::size_t item = 0;
    std::vector<Step> steps = {};
    bool operator==(const ScenePlace &) const = default;
};

/// `0: 0.3 0.7*12 1.4 `: the item's number, and the steps as SET.MAP, in the order of the text and from 0, *COUNT where one is
/// repeated, a blank after each.
[[nodiscard]] std::string textOf(const ScenePlace &place);

/// Reads what textOf() writes, and nothing else. Nothing where there are more steps than an Anchor goes down.
[[nodiscard]] std::optional<ScenePlace> scenePlaceFromText(std::string_view text);

}
