// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objslips.h"

#include <algorithm>
#include <string>

namespace romanesco {

namespace {

using Kind = ObjSlips::Kind;

struct Keyword {
    std::string_view word;
    Kind kind;
};
constexpr auto keywords = std::to_array<Keyword>({
    {"p", Kind::Points},           {"l", Kind::Lines},           {"vp", Kind::FreeForm},
    {"cstype", Kind::FreeForm},    {"deg", Kind::FreeForm},      {"bmat", Kind::FreeForm},
    {"step", Kind::FreeForm},      {"curv", Kind::FreeForm},     {"curv2", Kind::FreeForm},
    {"surf", Kind::FreeForm},      {"parm", Kind::FreeForm},     {"trim", Kind::FreeForm},
    {"hole", Kind::FreeForm},      {"scrv", Kind::FreeForm},     {"sp", Kind::FreeForm},
    {"end", Kind::FreeForm},       {"con", Kind::FreeForm},      {"mg", Kind::FreeForm},
    {"bevel", Kind::Settings},     {"c_interp", Kind::Settings}, {"d_interp", Kind::Settings},
    {"lod", Kind::Settings},       {"maplib", Kind::Settings},   {"usemap", Kind::Settings},
    {"ctech", Kind::Settings},     {"stech", Kind::Settings},    {"shadow_obj", Kind::Settings},
    {"trace_obj", Kind::Settings}, {"call", Kind::Commands},     {"csh", Kind::Commands},
});

/// Of the kinds that are passed over.
constexpr auto words = std::to_array<const char *>({
    "points",
    "lines that bound no face",
    "curves and surfaces",
    "settings for display",
    "files to call and commands to run",
    "unknown words",
});

DiagnosticCode codeOf(Kind kind)
{
    return kind == Kind::SmallNumber ? DiagnosticCode::ObjSmallNumbers
        : kind == Kind::Colour       ? DiagnosticCode::ObjColoursOutside
                                     : DiagnosticCode::ObjPassedOver;
}

}

ObjSlips::Kind ObjSlips::ofKeyword(std::string_view keyword)
{
    const auto *found = std::ranges::find(keywords, keyword, &Keyword::word);
    return found == keywords.end() ? Kind::Unknown : found->kind;
}

void ObjSlips::count(Kind kind, SourceRange place)
{
    Counted &counted = m_counted[static_cast<std::size_t>(kind)];
    counted.first = counted.count == 0 ? place : counted.first;
    ++counted.count;
}

void ObjSlips::report(Diagnostics &diagnostics) const
{
    for (std::size_t i = 0; i < m_counted.size(); ++i) {
        const auto &[first, count] = m_counted[i];
        if (count == 0) {
            continue;
        }
        std::vector<std::string> arguments{std::to_string(count) + (count == 1 ? " place" : " places")};
        if (i < words.size()) {
            arguments.emplace_back(words[i]);
        }
        diagnostics.push_back({codeOf(static_cast<Kind>(i)), first, std::move(arguments)});
    }
}

}
