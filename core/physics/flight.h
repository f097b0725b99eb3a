// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ballstep.h"

namespace romanesco {

/// Moves a ball that nothing holds up along its parabola until it touches, or to the end of the step, and lands it there. The
/// parabola is exact: only the way that is proved to be free before it is gone is made of chords.
void fly(BallStep &step);

}
