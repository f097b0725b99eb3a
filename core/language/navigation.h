// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"
#include "occurrences.h"

namespace romanesco {

/// Where a word leads. In all of this a cursor touches a word inside it and at either end, and any offset is allowed.
struct Target {
    /// Of the text: the name where it is declared, or the path that the cursor touches.
    SourceRange range;
    /// The file that a path names, as written; nothing where the word leads to a place in the text.
    std::optional<std::string> path = std::nullopt;
};

/// What F12 leads to. Nothing where there is no word that stands for something. Cost linear in the line; for <$> in the
/// number of objects.
[[nodiscard]] std::optional<Target> definition(const FdoDocument &document, std::size_t offset);

/// In a scene the paths of files lead to them.
[[nodiscard]] std::optional<Target> definition(const SdoSyntax &syntax, std::size_t offset);

/// All words that stand for what the word under the cursor stands for, its declaration among them, in the order of the
/// text. Cost linear in the text.
[[nodiscard]] std::vector<Occurrence> uses(const FdoDocument &document, std::size_t offset);

/// The name that rename() would change, to begin with. Nothing where it refuses whatever the new name.
[[nodiscard]] std::optional<SourceRange> renamable(const FdoDocument &document, std::size_t offset);

/// Another name for what the word under the cursor stands for: its declaration and all uses by name change, uses by
/// number stay. A vector that is just v gets a name of its own. The error is a sentence: there is no name, the new one
/// is none, is reserved or taken, or the words would mean something else afterwards. Words behind the error of a bad line
/// are not read and stay as they are. Cost linear in the text.
[[nodiscard]] std::expected<TextEdits, std::string> rename(const FdoDocument &document, std::size_t offset,
                                                           std::string_view newName);

}
