// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sourcerange.h"

namespace romanesco {

/// Other bytes for a range of a text; an empty range inserts.
struct TextEdit {
    SourceRange range;
    std::string text;
    bool operator==(const TextEdit &) const = default;
};

/// Edits that belong together. All ranges are of the text before; they ascend and do not overlap.
using TextEdits = std::vector<TextEdit>;

[[nodiscard]] std::string applied(std::string_view text, const TextEdits &edits);

/// The length of what two texts start with alike, and of what they end with alike. At memory's speed.
[[nodiscard]] std::size_t commonStart(std::string_view a, std::string_view b);
[[nodiscard]] std::size_t commonEnd(std::string_view a, std::string_view b);

}
