// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>

#include "core/text/diagnostic.h"
#include "core/text/lexer.h"

namespace romanesco {

/// Guesses at what a bad line of a scene was meant to be. Each looks ahead from where a vector or a transformation
/// starts, and gives nothing where it is in doubt.

/// Puts in the brackets and commas that a vector of three numbers lacks.
[[nodiscard]] std::optional<Fix> repairedVector(LineLexer ahead);

/// The same for a transformation and the vectors in it; where it ends too early the rest is `#`.
[[nodiscard]] std::optional<Fix> repairedTransform(LineLexer ahead);

/// Numbers that were written with decimal commas.
struct DecimalCommas {
    /// The first of them, as it is written, and with a point.
    SourceRange range;
    std::string number;
    Fix fix;
};
/// In a vector: a comma without blanks belongs to a number where that makes it three numbers.
[[nodiscard]] std::optional<DecimalCommas> decimalCommasInVector(LineLexer ahead);
/// In a number that stands alone.
[[nodiscard]] std::optional<DecimalCommas> decimalCommaInNumber(LineLexer ahead);

}
