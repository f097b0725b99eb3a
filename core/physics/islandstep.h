// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>

#include "ballpairs.h"
#include "crew.h"

namespace romanesco {

/// Steps balls that may touch one another: each along its own paths until two meet, which collide there, first things
/// first, and of what is at once the lower numbers first. Where that does not come to an end soon, since they lie on one
/// another, they are moved as a pile: velocities that press no two of them together, nor any against what it lies on, are
/// found by projected Gauss-Seidel, ball after ball, and overlap is taken out bit by bit. Balls of a pile that hardly
/// move for a while fall asleep.
///
/// balls and reports are those of the whole world; those of other islands are left alone.
void stepIsland(const BallIsland &island, std::span<BallState> balls, std::span<StepReport> reports, const Laws &laws,
                const Crew &crew);

}
