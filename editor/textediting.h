// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include "core/text/textedit.h"
#include "textsnapshot.h"

class QPlainTextEdit;

namespace romanesco {

/// Where a cursor at an offset goes when a text is edited: it stays at its word, whether it stands in front of it, inside
/// or behind.
[[nodiscard]] std::size_t movedOffset(std::size_t offset, const TextEdits &edits, const std::string &text);

/// An undo step of its own, or a part of the last one.
enum class UndoStep { Own, Last };

/// Edits the text of an editor as one undo step; the cursor and the selection stay at their words, and the view where it
/// is. Ranges are of that text, which the document still has. Nothing happens where there are no edits or the text is
/// read-only.
void applyEdits(QPlainTextEdit &editor, const TextEdits &edits, const TextSnapshot &text,
                UndoStep step = UndoStep::Own);

/// What else edits whole lines, each one undo step that does nothing in a read-only text.

/// Makes the lines of the selection comments, or where all of them are, makes them none. Blank lines stay as they are.
void toggleComment(QPlainTextEdit &editor);

/// Writes the lines of the selection once more below; the cursor and the selection go there.
void duplicateLines(QPlainTextEdit &editor);

}
