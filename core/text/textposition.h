// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

namespace romanesco {

/// A place in a text as people count: line and column from 1, columns in code points.
struct TextPosition {
    std::size_t line = 1;
    std::size_t column = 1;
    bool operator==(const TextPosition &) const = default;
};

}
