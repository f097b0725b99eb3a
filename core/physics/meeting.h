// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <span>

#include "ballstep.h"

namespace romanesco {

/// When two balls that go along their paths meet first, at a time from `from` on: where they are as near as their radii and
/// come nearer to each other. Nothing where that is not within both paths. Exact where both have one acceleration, so that
/// the distance is a quadratic; else gone on by as much as they cannot have come nearer, to 1e-9 of the radii.
[[nodiscard]] std::optional<double> meetingOf(std::span<const BallPath> one, std::span<const BallPath> other,
                                              double from);

/// Turns round, by the restitution of both, what two balls that touch have of their velocities against each other; a bounce
/// is left out as with surfaces (see land()), where `pull` is what brings them together again. Their momentum is kept.
void collide(BallState &one, BallState &other, double pull, double timeStep);

}
