// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/fractaldescription.h"
#include "core/fractal/address.h"
#include "fdodocument.h"

namespace romanesco {

/// One step of an address as the text has it.
struct OriginStep {
    /// What the step is called: `z[3] u.7.11`, the declaration with the pass of its iteration (from 1) and the use.
    std::string words;
    /// The use, and the name of the declaration whose set it is in.
    SourceRange use;
    SourceRange declaration;
    /// Which pass (from 1) of the iteration that the depth of <$> counts (see FractalDescription::depth); so with that depth
    /// the step is in the last. Nothing for a step of no such iteration.
    std::optional<std::uint64_t> pass = {};
};

/// Where a copy comes from. The document must be the one that the description was read from; picks beyond its levels or
/// its sets end the list. Cost: for each pick a logarithm of the declarations for each recursive round it.
[[nodiscard]] std::vector<OriginStep> origin(const FdoDocument &document, const FractalDescription &description,
                                             const Address &address);

/// A map of a set, wherever the set occurs: what a use in the text stands for. A copy is made by it where one of its
/// picks is at a level with this set and takes this map.
struct UseOfSet {
    SetId set = 0;
    /// Nothing for `#`, which makes no step.
    std::optional<std::uint32_t> map;
    bool operator==(const UseOfSet &) const = default;
};

/// What the use at an offset stands for; nothing where none stands there or its declaration is bad. A use that repeats an
/// earlier one of its set stands for that one.
[[nodiscard]] std::optional<UseOfSet> useAt(const FdoDocument &document, const FractalDescription &description,
                                            std::size_t offset);

}
