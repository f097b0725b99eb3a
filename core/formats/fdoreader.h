// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string_view>

#include "core/text/diagnostic.h"
#include "fdomodel.h"
#include "fractaldescription.h"

namespace romanesco {

/// What an .fdo text means, beside all that is wrong with it.
struct FdoResult {
    /// Of lines, names and maps, sorted by place.
    Diagnostics diagnostics;
    /// There where nothing that the result <$> needs is wrong.
    std::optional<FractalDescription> description;
};

/// Computes the maps of all sets and writes out the levels of <$>. Cost: some hundred nanoseconds for each use.
[[nodiscard]] FdoResult describeFdo(const FdoSyntax &syntax, const FdoModel &model);

/// From the text to its meaning.
[[nodiscard]] FdoResult readFdo(std::string_view text);

}
