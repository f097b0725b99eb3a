// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ballstep.h"

namespace romanesco {

/// Moves a ball through a time, on a surface alone: it flies, lands and slides in turn. The speed rises by gravity alone.
/// A ball that sleeps stays where it is. Cost: a query for some steps in the air, two or three a step on the surface.
/// Its paths are added where they are wanted; none is where it sleeps.
StepReport stepBall(BallState &ball, const Laws &laws, Probe &probe, double time,
                    std::vector<BallPath> *paths = nullptr);

}
