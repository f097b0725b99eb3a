// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace romanesco {

/// What may stand at the start of a text in UTF-8 and is not part of it.
constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

/// One code point read from UTF-8. length is the number of bytes it takes; an ill-formed byte is a code point of its
/// own with isValid false, so that a reader always moves on.
struct CodePoint {
    char32_t value = 0;
    std::size_t length = 1;
    bool isValid = false;
};

/// The code point at the start of a non-empty text. Overlong forms, surrogates and values past U+10FFFF are ill-formed.
[[nodiscard]] CodePoint firstCodePoint(std::string_view text);

[[nodiscard]] std::size_t codePointCount(std::string_view text);

/// A letter or `_`. Beyond ASCII every code point counts as a letter, except in the blocks where Unicode gathers its
/// spaces, controls, punctuation and symbols: close enough for names, which are only compared, and needs no tables.
[[nodiscard]] bool isNameStart(char32_t value);
[[nodiscard]] bool isNamePart(char32_t value);

}
