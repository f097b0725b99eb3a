// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ballstep.h"

namespace romanesco {

/// Moves a ball as the dissertation does (4.4.1, 4.4.4), for comparison: velocity, then position, by the whole time; and where
/// it overlaps the surface then, it is pushed out along the line from the closest point, and its velocity along that line is
/// turned round by its restitution. It sinks in, loses energy, and goes through what is thinner than its way.
StepReport stepAsInDissertation(BallState &ball, const Laws &laws, Probe &probe, double time);

}
