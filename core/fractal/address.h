// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/formats/levelsequence.h"

namespace romanesco {

/// A map of the set at a level.
struct Pick {
    Position position = 0;
    std::uint32_t map = 0;
    bool operator==(const Pick &) const = default;
};

/// Names a copy: the picks that lead to it, outermost first. Levels that are passed over (their `#` is taken) are left
/// out, so that equal copies have equal addresses.
using Address = std::vector<Pick>;

}
