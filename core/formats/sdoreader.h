// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string_view>

#include "core/text/diagnostic.h"
#include "scenedescription.h"
#include "sdosyntax.h"

namespace romanesco {

/// What an .sdo text means, beside all that is wrong with it. Files that it names are not looked at.
struct SdoResult {
    /// Sorted by place.
    Diagnostics diagnostics;
    /// There where nothing is wrong.
    std::optional<SceneDescription> description;
};

/// Puts together what the lines say. Cost linear in the text.
[[nodiscard]] SdoResult describeSdo(const SdoSyntax &syntax);

/// From the text to its meaning.
[[nodiscard]] SdoResult readSdo(std::string_view text);

}
