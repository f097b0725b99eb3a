// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace romanesco {

/// A kind of text of any size, for measuring what reading costs: .fdo, .sdo where its name starts with "scene", or .obj
/// where it starts with "obj". The same n gives the same text.
struct TextShape {
    std::string_view name;
    /// n counts what the shape is about: lines, uses, bytes.
    std::string (*make)(std::size_t n);
    /// An n to read in some milliseconds, and one beyond what anybody writes.
    std::size_t smallSize;
    std::size_t largeSize;
    /// Whether the text is right, without a warning; else it is wrong on purpose.
    bool isRight;
};

/// First "person", what somebody could have written, then texts that are made to be hard.
[[nodiscard]] std::span<const TextShape> textShapes();

/// nullptr where there is none of that name.
[[nodiscard]] const TextShape *findTextShape(std::string_view name);

}
