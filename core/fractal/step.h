// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>

#include "core/formats/levelsequence.h"

namespace romanesco {

/// A map of a set, as the way from a state of a StateTable to its child.
struct Step {
    SetId set = 0;
    std::uint32_t map = 0;
    bool operator==(const Step &) const = default;
};

}
