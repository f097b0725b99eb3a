// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "core/language/writtennumber.h"

namespace romanesco {

class LanguageText;

/// A number of a text that can be moved by hand.
struct NumberPlace {
    WrittenNumber number;
    /// The least that a whole number may be: 1 where it stands for a vector, 0 for a depth. Other numbers are free.
    std::optional<double> leastWhole;
};

/// The number that a position touches; none in comments, names and paths. Cost linear in the line.
[[nodiscard]] std::optional<NumberPlace> numberAt(LanguageText &text, int position);

/// The number moved by so many steps of its last decimal, or of one behind it where finer is asked for; a whole number
/// stays whole and above its least.
[[nodiscard]] TextEdit stepped(const NumberPlace &place, int steps, bool isFiner);

}
