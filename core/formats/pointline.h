// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace romanesco {

/// What is wrong in a line: where, in code points from 1, and a sentence.
struct PointSlip {
    std::size_t column = 1;
    std::string words;
};

/// `x y z`, in plain decimal numbers no larger than `farthest`, with blanks between and around; nothing for a line of
/// blanks. The line is without its end, and may hold any bytes; what the words quote of it is short, and text.
[[nodiscard]] std::expected<std::optional<glm::dvec3>, PointSlip> pointOf(std::string_view line, double farthest);

}
