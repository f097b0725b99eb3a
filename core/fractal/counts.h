// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "core/base/count.h"
#include "fractalgraph.h"

namespace romanesco {

/// The product of all level sizes, `#` counted: the words as the text writes them. Cost: a product for each slot and
/// some for each repeat.
[[nodiscard]] Count instancesAsWritten(const FractalGraph &graph);

/// The canonical words: instances that differ. Exact wherever Count is. Nothing where counting would take more than
/// some seconds: more than 48 different sets in a repeat of more than 10^5 levels, thousands of levels of as many sets
/// (levels times sets above 5·10^6), or a map shared by a set that may be passed over and one that may not, with more
/// than 10^5 states.
///
/// Counts from the last level up. L(p), the words from position p on, are the empty word (if no pick is needed) and,
/// for each map m, m followed by what may come after m's first possible place. So the vector (1 if no pick is needed;
/// for each set, the number of words after its first place) is enough, each level maps it linearly, and a repeat is a
/// matrix power. Sets that share maps are split into the parts that occur together.
[[nodiscard]] std::optional<Count> instancesDistinct(const FractalGraph &graph);

}
