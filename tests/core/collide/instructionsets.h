// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>

#include <hwy/targets.h>

namespace romanesco::test {

/// Runs something with each set of instructions that this processor and the program have: the widest last, which is used
/// again from then on. How many there are.
inline std::size_t withEveryInstructionSet(const auto &run)
{
    const auto targets = hwy::SupportedAndGeneratedTargets();
    for (std::size_t i = targets.size(); i-- > 0;) { // the widest first
        hwy::SetSupportedTargetsForTest(targets[i]);
        run();
    }
    hwy::SetSupportedTargetsForTest(0);
    return targets.size();
}

}
