// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "core/formats/sdosyntax.h"
#include "fdodocument.h"
#include "writtennumber.h"

namespace romanesco {

/// A vector as a text has it, for something that changes it, such as a hand. What stands there may be a `#`, which becomes
/// a vector with that.
struct WrittenVector {
    /// From the first number to the last, or the `#`.
    SourceRange range;
    /// Its numbers; of a `#` those of the identity of its place.
    std::array<WrittenNumber, 3> numbers;
    std::array<std::string, 3> words;
    /// What stands in the range round the numbers and between them: nothing but separators, for a vector that is written.
    std::array<std::string, 4> between;
    /// How many places the text uses it for, the one that was asked about included.
    std::size_t uses = 1;

    [[nodiscard]] glm::dvec3 value() const;
    /// The text of the range with another value: numbers that stay as they are keep their words, the others as many
    /// decimals as they have and at least so many.
    [[nodiscard]] std::string with(const glm::dvec3 &value, int leastDecimals = 0) const;
};

/// Where something stands, as a text says it: the values of position, rotation in degrees and scale, and the vectors that
/// they come from; none for a part that no single vector says.
struct WrittenPlace {
    TransformParts parts;
    std::array<std::optional<WrittenVector>, 3> vectors;
};

/// What the use of a transformation that begins at an offset says; nothing where none begins there, where it is `#` or wrong.
/// Cost linear in the text: uses are counted.
[[nodiscard]] std::optional<WrittenPlace> placeOfUse(const FdoDocument &document, std::size_t offset);

/// Of the file that a scene places as the item of that number, from 0; nothing where there is none.
[[nodiscard]] std::optional<WrittenPlace> placeOfItem(const SdoSyntax &scene, std::size_t item);

}
