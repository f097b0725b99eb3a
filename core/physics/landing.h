// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ballstep.h"

namespace romanesco {

/// Answers all contacts of a ball that touches, after a measure(): it bounces off each direction that it moves against, the
/// first time by its restitution, then not at all, until it moves against none; what it is left against, it slides along
/// or rests on. A bounce is left out where all that would follow fit into a time step. The speed does not rise.
void land(BallStep &step);

/// Finds what holds up a ball that touches in several directions at once, after a measure().
void findSupports(BallStep &step);

/// Takes from a ball that touches what it would leave with only to be back at once (see land()). Whether there was any of
/// that.
bool settle(BallStep &step);

}
