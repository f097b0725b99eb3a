// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include "ballpairs.h"
#include "crew.h"

namespace romanesco {

/// Steps balls that lie on one another and on a surface: see stepIsland(). What each ball asks of
/// the surface is shared among a crew.
void stepPile(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
              const Crew &crew);

}
