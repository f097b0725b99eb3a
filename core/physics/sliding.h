// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "ballstep.h"

namespace romanesco {

/// Moves a ball along what it lies against until it touches something else, until the surface falls away below it, or to
/// the end of the step. Puts it to sleep where nothing moves it.
void slide(BallStep &step);

}
