// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

namespace romanesco {

class FdoEditor;

/// Asks, in place, for another name for what the word at the cursor stands for, and gives it: one undo step for the
/// declaration and all uses. Where nothing can be renamed the reason is said instead.
void askForName(FdoEditor &editor);

/// Asks for the number of a line, and goes there.
void askForLine(FdoEditor &editor);

}
