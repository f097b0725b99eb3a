// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "core/text/diagnostic.h"
#include "fdosyntax.h"
#include "fractaldescription.h"

namespace romanesco {

/// What an .fdo text means, beside all that is wrong with it.
struct FdoResult {
    /// Of parsing and of meaning, sorted by place.
    Diagnostics diagnostics;
    /// There where nothing that the result <$> needs is wrong.
    std::optional<FractalDescription> description;
};

/// Finds what every name stands for and what <$> is. Uses of names whose declaration is bad pass without a message.
/// Cost linear in the text, times a logarithm for each recursive.
[[nodiscard]] FdoResult resolveFdo(const FdoSyntax &syntax);

/// parseFdo and resolveFdo in one.
[[nodiscard]] FdoResult readFdo(std::string_view text);

}
