// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "textedit.h"

namespace romanesco {

/// Lines [oldBegin, oldEnd) of one text became lines [newBegin, newEnd) of another; from 0, either may be empty.
struct LineChange {
    std::size_t oldBegin;
    std::size_t oldEnd;
    std::size_t newBegin;
    std::size_t newEnd;
    bool operator==(const LineChange &) const = default;
};

/// The lines of a text, without their ends (LF): one more than there are ends, as an editor counts them.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

/// What differs, in the fewest lines (Myers, "An O(ND) Difference Algorithm", 1986); ascending, with lines that are alike
/// between them. Where more than 2,000 lines differ between the first and the last that do, all between these is one change.
/// Costs at most 2,000 passes over the lines, and 16 MB.
[[nodiscard]] std::vector<LineChange> lineChanges(const std::vector<std::string_view> &before,
                                                  const std::vector<std::string_view> &after);

/// Edits that make a text of another: one for each change of lines, and of those only what differs between their ends. All
/// places are between characters, where both texts are UTF-8.
[[nodiscard]] TextEdits editsBetween(std::string_view before, std::string_view after);

}
