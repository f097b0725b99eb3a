// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "core/formats/fdosyntax.h"
#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"

namespace romanesco {

/// The edits that tidy a text's layout: one blank between words that stand apart and none elsewhere, no blanks at the
/// ends of a line, one blank line where there were more and none at the ends of the text, one line end after the last
/// line. The trailing dot of a use goes. What the text means, the words of its comments, the spelling of its numbers, its
/// kinds of line ends and a byte order mark stay.
///
/// Columns stay: where the first numbers of adjacent vectors, or the comments after adjacent declarations, stand in one
/// column behind words of different lengths, they are kept there, and the others of that run are moved there if they fit.
///
/// Of a line with an error only the blanks at its end go. A text that is not UTF-8 or holds a NUL has no edits, and
/// neither has what the edits make of a text. Only what changes is edited. Cost linear in the text.
[[nodiscard]] TextEdits formatting(const FdoSyntax &syntax);
[[nodiscard]] TextEdits formatting(const SdoSyntax &syntax);

}
