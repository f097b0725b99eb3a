// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

#include "ask.h"
#include "core/physics/ball.h"
#include "core/physics/surface.h"

namespace romanesco {

/// What balls ask about a surface while they fall on it, each by itself, for five seconds: so many of the questions, spread
/// over all of that evenly. None once a stop is asked for. Costs a second or so where balls are many.
[[nodiscard]] std::vector<Ask> asksOfBalls(const Surface &surface, std::span<const Ball> balls, std::size_t count,
                                           const std::stop_token &stop = {});

}
