// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/text/textedit.h"

namespace romanesco {

/// A number as it is written: what a slider or a drag may change.
struct WrittenNumber {
    SourceRange range;
    double value = 0.0;
    /// Digits after the decimal point.
    int decimals = 0;
    /// Of `e-3`, kept as it is.
    int exponent = 0;
    /// As written: `e-3`, or empty.
    std::string exponentText;
    bool hasPlus = false;
};

/// What is written in a range of a text; nothing where that is no number.
[[nodiscard]] std::optional<WrittenNumber> writtenNumber(std::string_view text, SourceRange range);

/// Another value in the number's place, with as many decimals as it has and its exponent: dragging turns `0.50` into
/// `0.51`, never into `0.51000000000000001`. A value that is not finite changes nothing.
[[nodiscard]] TextEdit withValue(const WrittenNumber &number, double value);

/// The number moved by so many steps, a step being one in its last decimal; `finer` gives it so many decimals more
/// first, of 15 at most.
[[nodiscard]] TextEdit stepped(WrittenNumber number, int steps, int finer = 0);

}
