// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <vector>

#include "boundedstates.h"
#include "lanes.h"

namespace romanesco {

/// The coarse hulls of a state's children, in the state's frame; with an infinite error where a child has none, so that it
/// raises nothing. None at all where no child has one.
[[nodiscard]] std::vector<HullsOfFew> hullsOf(std::span<const DescentStep> children, BoundedStates &states);

}
