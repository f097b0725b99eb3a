// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "filetrouble.h"

#include <algorithm>
#include <format>
#include <iterator>

#include "core/text/linemap.h"

namespace romanesco {

namespace {

constexpr std::size_t mostNotes = 10;

/// Of those diagnostics of a text that are no less severe; what stands for several of them.
FileTrouble sumOf(const Diagnostics &diagnostics, Severity least, const char *several, std::string_view text)
{
    const LineMap lines(text);
    FileTrouble trouble{DiagnosticCode::BadMesh, {}, {}};
    std::size_t count = 0;
    for (const Diagnostic &diagnostic : diagnostics) {
        if (diagnostic.severity() > least || ++count > mostNotes) {
            continue;
        }
        const TextPosition at = lines.position(diagnostic.range.begin);
        trouble.notes.push_back({diagnostic.code, diagnostic.range, diagnostic.arguments, {}, at});
        if (count == 1) {
            trouble.reason = std::format("line {}, column {}: {}", at.line, at.column, diagnostic.message());
        }
        std::ranges::copy_if(diagnostic.notes, std::back_inserter(trouble.notes),
                             [](const Note &note) { return !note.file.empty(); });
    }
    if (count > 1) {
        trouble.reason = std::format("{} {}, the first in {}", count, several, trouble.reason);
    }
    return trouble;
}

}

FileTrouble troubleOf(const Diagnostics &diagnostics, std::string_view text)
{
    return sumOf(diagnostics, Severity::Error, "errors", text);
}

FileTrouble remarksOf(const Diagnostics &diagnostics, std::string_view text)
{
    FileTrouble trouble = sumOf(diagnostics, Severity::Warning, "remarks", text);
    trouble.code = DiagnosticCode::FileRemarks;
    return trouble;
}

Diagnostic remark(const FileTrouble &trouble, const std::string &name, SourceRange place)
{
    Diagnostic diagnostic{trouble.code, place, {name, trouble.reason}, {}, trouble.notes};
    if (trouble.code == DiagnosticCode::MeshWithoutFaces) {
        diagnostic.arguments = {'"' + name + '"'};
    } else if (trouble.code == DiagnosticCode::Overflow) {
        diagnostic.arguments.clear();
    }
    for (Note &note : diagnostic.notes) {
        note.file = seenFrom(name, note.file);
    }
    return diagnostic;
}

}
