// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include "core/text/textedit.h"
#include "fdodocument.h"

namespace romanesco {

/// What keeps uses of vectors by number true after vectors were inserted or removed above them.
struct Renumbering {
    /// Of the text after. Empty where every number still means the same vector.
    TextEdits edits;
    /// Uses of vectors that are gone, in the text after; they stay as they are. (A number that meant no vector before
    /// stays too, and is none of these.)
    std::vector<SourceRange> orphans;
};

/// Compares two versions of a text. Lines that both start or end with are the same lines, so their uses should mean the
/// same vectors; what stands in between was written anew and says what its author means. Cost linear in the text.
[[nodiscard]] Renumbering renumbering(const FdoDocument &before, const FdoDocument &after);

}
