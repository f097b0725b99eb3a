// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "core/text/sourcerange.h"

namespace romanesco {

/// What a cursor's place in a line of .fdo asks for, by the grammar and by what stands to the left of it.
struct FdoPlace {
    enum class Kind {
        Nothing,   ///< a comment, a number, a new name, a dot or a bracket
        LineStart, ///< a declaration's name; `<`, `<$` and `<$>` are begun words too
        Part,      ///< a part of a transformation: t. (|
        Value,     ///< x. |
        MeshPath,  ///< inside the quotes of a value
        BaseName,  ///< z<|
        UseName,   ///< x. [|
        Argument,  ///< x. [t.|
    };
    Kind kind = Kind::Nothing;
    /// The word that is begun, from its first byte to the cursor, counted from the start of the line; of a path, from
    /// behind the quote. Empty at the cursor where none is.
    LineRange begun;
    /// Of a Part: the line's parameters.
    std::vector<std::string_view> parameters;
    /// Of a Value or a MeshPath: the base of the recursive whose body it is. Else empty.
    std::string_view base;
    /// Of an Argument: the transformation, and how many arguments it has before this one.
    std::string_view transformation;
    std::size_t argument = 0;
};

/// The place at the end of what is given: a line up to the cursor, whose first bytes, so many, are passed over. The names
/// are views of it. Cost linear.
[[nodiscard]] FdoPlace fdoPlace(std::string_view line, std::size_t skipped);

}
