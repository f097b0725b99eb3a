// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdio>
#include <cstdlib>
#include <source_location>
#include <string_view>

#include "core/text/diagnostic.h"
#include "core/text/linemap.h"
#include "core/text/places.h"

namespace romanesco {

/// Always on, unlike assert().
inline void require(bool holds, std::source_location place = std::source_location::current())
{
    if (!holds) {
        std::fprintf(stderr, "%s:%u does not hold\n", place.file_name(), static_cast<unsigned>(place.line()));
        std::abort();
    }
}

/// A fix changes the text, within it and from its start to its end.
inline void requireSound(const Fix &fix, std::string_view text)
{
    std::size_t at = 0;
    for (const TextEdit &edit : fix.edits) {
        require(edit.range.begin >= at && edit.range.begin <= edit.range.end && edit.range.end <= text.size());
        at = edit.range.end;
    }
    require(applied(text, fix.edits) != text);
}

/// What holds for the diagnostics of any text: each lies in it, and can be put into words at a line of it.
inline void requireSound(const Diagnostics &diagnostics, std::string_view text)
{
    if (diagnostics.empty()) {
        return;
    }
    const LineMap lines(text);
    Places places(lines);
    for (const Diagnostic &diagnostic : diagnostics) {
        require(diagnostic.range.begin <= diagnostic.range.end && diagnostic.range.end <= text.size());
        require(!toLines(diagnostic, "file", places).empty());
        if (diagnostic.fix) {
            requireSound(*diagnostic.fix, text);
        }
    }
}

}
