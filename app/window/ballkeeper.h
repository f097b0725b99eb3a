// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QString>

#include "core/physics/livesimulation.h"

namespace romanesco {

class TextTab;

/// Writes all balls into the text of a scene, where they are and as fast as they are, in one step of undo. The scene is
/// what the text says. Where it has no balls yet, they are of a mesh `ball.obj`, which is put beside the text. Returns what
/// is in the way, as a sentence, or nothing.
[[nodiscard]] QString keepBalls(TextTab &tab, const Scene &scene, const LiveSimulation::Frame &frame);

}
