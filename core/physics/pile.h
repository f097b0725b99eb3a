// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include "ballpairs.h"

namespace romanesco {

/// Steps balls that lie on one another and on a surface: see stepIsland().
void stepPile(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
              Probe &probe);

}
