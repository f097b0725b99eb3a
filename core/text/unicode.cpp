// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "unicode.h"

namespace romanesco {

CodePoint firstCodePoint(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned lead = byte(0);
    if (lead < 0x80) {
        return {lead, 1, true};
    }
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) {
        return {lead, 1, false};
    }
    char32_t value = lead & (0xFFu >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) {
            return {lead, 1, false};
        }
        value = (value << 6) | (byte(i) & 0x3Fu);
    }
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool isSurrogate = value >= 0xD800 && value <= 0xDFFF;
    if (value < least[length] || value > 0x10FFFF || isSurrogate) {
        return {lead, 1, false};
    }
    return {value, length, true};
}

std::size_t codePointCount(std::string_view text)
{
    std::size_t count = 0;
    while (!text.empty()) {
        text.remove_prefix(firstCodePoint(text).length);
        ++count;
    }
    return count;
}

bool isNameStart(char32_t value)
{
    if (value < 0x80) {
        return (value >= 'a' && value <= 'z') || (value >= 'A' && value <= 'Z') || value == '_';
    }
    struct Block {
        char32_t first;
        char32_t last;
    };
    constexpr Block others[] = {
        {0x80, 0xA9},     {0xAB, 0xB4},     {0xB6, 0xB9},     {0xBB, 0xBF},     {0xD7, 0xD7},     {0xF7, 0xF7},
        {0x1680, 0x1680}, {0x2000, 0x2070}, {0x207A, 0x207E}, {0x20A0, 0x20FF}, {0x2190, 0x2BFF}, {0x2E00, 0x2E7F},
        {0x3000, 0x3004}, {0x3008, 0x3020}, {0xD800, 0xF8FF}, {0xFE10, 0xFE6F}, {0xFEFF, 0xFF0F}, {0xFFF0, 0xFFFF}};
    for (const Block &block : others) {
        if (value >= block.first && value <= block.last) {
            return false;
        }
    }
    return true;
}

bool isNamePart(char32_t value)
{
    return isNameStart(value) || (value >= '0' && value <= '9');
}

}
