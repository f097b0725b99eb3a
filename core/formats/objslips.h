// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/text/diagnostic.h"

namespace romanesco {

/// What an OBJ file may hold a million times without harm: one warning for all of a kind.
class ObjSlips
{
public:
    enum class Kind { Points, Lines, FreeForm, Settings, Commands, Unknown, SmallNumber, Colour };

    /// The kind of statement that starts with a keyword which is passed over.
    [[nodiscard]] static Kind ofKeyword(std::string_view keyword);

    void count(Kind kind, SourceRange place);
    /// Appends a warning for each kind, at the first of it.
    void report(Diagnostics &diagnostics) const;

private:
    struct Counted {
        SourceRange first;
        std::size_t count = 0;
    };
    std::array<Counted, static_cast<std::size_t>(Kind::Colour) + 1> m_counted{};
};

}
