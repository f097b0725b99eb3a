// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <filesystem>

#include "shrinkingball.h"
#include "tests/bench/render/ourframes.h"

namespace romanesco::bench {

/// The picture of docs/evaluation.md, into a file. Columns: exact, greedy, octree; rows: after the first contact, at rest,
/// and when it was last held before it fell, or has fallen where it had no rest. Ends the program where it cannot be
/// written.
void writeBallPicture(OurFrames &frames, const ShrinkingGround &ground, const PicturedBall &ball,
                      const std::filesystem::path &path);

}
