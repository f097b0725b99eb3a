// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/text/diagnostic.h"

namespace romanesco {

/// What is wrong with a file that a text names: a remark of that text but for the file's name and the place.
struct FileTrouble {
    DiagnosticCode code;
    /// "no such file"; "3 errors, the first in line 4, column 2: …". Empty where the code says it all.
    std::string reason;
    /// The first errors in the file, and in the files that it names; file is empty or relative to its folder.
    std::vector<Note> notes;
};

/// One sentence and a note for each of the first errors of a text.
[[nodiscard]] FileTrouble troubleOf(const Diagnostics &diagnostics, std::string_view text);

/// A warning: the same of errors and warnings of a text that is used all the same.
[[nodiscard]] FileTrouble remarksOf(const Diagnostics &diagnostics, std::string_view text);

/// At the place where a text names the file so.
[[nodiscard]] Diagnostic remark(const FileTrouble &trouble, const std::string &name, SourceRange place);

}
