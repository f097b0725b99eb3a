// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"
#include "fdodocument.h"

namespace romanesco {

enum class CompletionKind { Keyword, Identity, Vector, Parameter, Transformation, Object, Recursive, File };

/// One way to go on at a cursor.
struct Completion {
    std::string label;
    /// A vector's value, a transformation's parameters: what tells one from another. May be empty.
    std::string detail;
    /// In place of the word that the cursor stands in or behind; where there is none, or only one that starts at the
    /// cursor, it inserts. The cursor goes to the end of what is written.
    TextEdit edit;
    CompletionKind kind = CompletionKind::Keyword;
};

/// The paths that a value may name, relative to the text's folder, in the order wanted.
using FileNames = std::function<std::vector<std::string>()>;

/// Beyond so many nobody looks; typing a letter more leaves fewer.
constexpr std::size_t mostCompletions = 1'000;

/// What may stand at a cursor by the grammar, begins as the word there does (upper and lower case of ASCII are alike) and
/// is declared above. Nothing in a comment, and where a new name or a number is asked for. Of vectors, transformations,
/// objects and recursives the nearest above come first; parameters before vectors, names before files.
///
/// files is asked only where a path may stand; those that end otherwise are left out. Any offset is allowed. Cost linear
/// in the line, the declarations and the files.
[[nodiscard]] std::vector<Completion> complete(const FdoDocument &document, std::size_t offset, const FileNames &files);

/// The same for a scene: the letters that start a line (no second camera), #, files by the letter, and the two kinds of
/// camera.
[[nodiscard]] std::vector<Completion> complete(const SdoSyntax &syntax, std::size_t offset, const FileNames &files);

}
