// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/formats/fdomodel.h"
#include "core/formats/sdosyntax.h"
#include "core/text/sourcerange.h"
#include "fdodocument.h"

namespace romanesco {

/// What a tool tip says about a place in a text: plain short lines, numbers with six digits.
struct Hover {
    /// What it is about.
    SourceRange range;
    std::string title;
    std::vector<std::string> lines;
};

/// A vector shows its number and value; a transformation its parts; a use of one its parts and its map; an object or
/// recursive its levels and how many instances they make; a depth what it multiplies; a path the file. Nothing where
/// there is nothing to say. A cursor touches a word inside it and at either end, and any offset is allowed. Cost linear
/// in the line; for objects see levelFacts().
[[nodiscard]] std::optional<Hover> hover(const FdoDocument &document, std::size_t offset);

/// The camera shows where it looks, a transformation its map, a path the file, other lines what they place.
[[nodiscard]] std::optional<Hover> hover(const SdoSyntax &syntax, std::size_t offset);

/// The parts of a transformation and its map: matrix, operator norm, determinant, whether it is a similarity, mirrored
/// or flat.
[[nodiscard]] std::vector<std::string> transformWords(const TransformParts &parts);

}
