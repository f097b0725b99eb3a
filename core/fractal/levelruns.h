// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

#include "core/formats/levelsequence.h"

namespace romanesco {

/// A level, or passes of a repeat.
struct LevelRun {
    LevelSequence::Slot slot = 0;
    /// 0 for the level alone.
    std::uint32_t repeat = 0;
    std::uint64_t passes = 1;
};

/// The levels from one position to another that no repeat goes over, as few runs, however many passes. Cost: linear in
/// the slots between them.
[[nodiscard]] std::vector<LevelRun> runsBetween(const LevelSequence &levels, Position begin, Position end);

/// One pass of a repeat, inner repeats as they are.
[[nodiscard]] std::vector<LevelRun> runsOfPass(const LevelSequence &levels, std::uint32_t repeat);

}
