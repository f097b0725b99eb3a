// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "textedit.h"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace romanesco {

std::string applied(std::string_view text, const TextEdits &edits)
{
    std::string result;
    std::size_t at = 0;
    for (const TextEdit &edit : edits) {
        assert(edit.range.begin >= at && edit.range.end >= edit.range.begin && edit.range.end <= text.size()
               && "edits ascend, do not overlap, and lie in the text");
        result += text.substr(at, edit.range.begin - at);
        result += edit.text;
        at = edit.range.end;
    }
    result += text.substr(at);
    return result;
}

std::size_t commonStart(std::string_view a, std::string_view b)
{
    constexpr std::size_t block = 4096;
    const std::size_t most = std::min(a.size(), b.size());
    std::size_t length = 0;
    while (length + block <= most && std::memcmp(a.data() + length, b.data() + length, block) == 0) {
        length += block;
    }
    while (length < most && a[length] == b[length]) {
        ++length;
    }
    return length;
}

std::size_t commonEnd(std::string_view a, std::string_view b)
{
    constexpr std::size_t block = 4096;
    const std::size_t most = std::min(a.size(), b.size());
    const char *const aEnd = a.data() + a.size();
    const char *const bEnd = b.data() + b.size();
    std::size_t length = 0;
    while (length + block <= most && std::memcmp(aEnd - length - block, bEnd - length - block, block) == 0) {
        length += block;
    }
    while (length < most && *(aEnd - length - 1) == *(bEnd - length - 1)) {
        ++length;
    }
    return length;
}

}
