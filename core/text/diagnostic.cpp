// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "diagnostic.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <format>

#include "places.h"
#include "unicode.h"

namespace romanesco {

namespace {

struct Row {
    std::string_view name;
    Severity severity;
    std::string_view words;
};

constexpr auto table = std::to_array<Row>({
#define DIAGNOSTIC(code, name, severity, words) {name, Severity::severity, words},
#include "diagnostics.def"
#undef DIAGNOSTIC
});

const Row &row(DiagnosticCode code)
{
    return table[static_cast<std::size_t>(code)];
}

/// An argument as it may be shown: what is no UTF-8 and control characters as U+FFFD, and only the start of what is
/// long. (A file may hold a word of a megabyte.)
void appendShown(std::string &text, std::string_view argument)
{
    constexpr int longest = 200;
    for (int i = 0; !argument.empty(); ++i) {
        if (i == longest) {
            text += "…";
            return;
        }
        const CodePoint point = firstCodePoint(argument);
        const bool isShown = point.isValid && point.value >= 0x20 && point.value != 0x7F;
        text += isShown ? argument.substr(0, point.length) : std::string_view("\uFFFD");
        argument.remove_prefix(point.length);
    }
}

}

std::string_view name(DiagnosticCode code)
{
    return row(code).name;
}

Severity severity(DiagnosticCode code)
{
    return row(code).severity;
}

std::string_view name(Severity severity)
{
    switch (severity) {
    case Severity::Error:
        return "error";
    case Severity::Warning:
        return "warning";
    case Severity::Hint:
        break;
    }
    return "hint";
}

std::string message(DiagnosticCode code, const std::vector<std::string> &arguments)
{
    // Arguments come from files and may hold braces: replaced by hand, in one pass, never through a format string.
    const std::string_view words = row(code).words;
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool isArgument = words[i] == '{' && i + 2 < words.size() && words[i + 2] == '}';
        if (!isArgument) {
            text += words[i];
            continue;
        }
        const std::size_t index = static_cast<std::size_t>(words[i + 1] - '0');
        assert(index < arguments.size() && "a message names an argument that was not given");
        appendShown(text, arguments[index]);
        i += 2;
    }
    return text;
}

Fix insertion(std::string title, std::size_t at, std::string text)
{
    return replacement(std::move(title), {at, at}, std::move(text));
}

Fix replacement(std::string title, SourceRange range, std::string text)
{
    return {std::move(title), {{range, std::move(text)}}};
}

bool hasErrors(const Diagnostics &diagnostics)
{
    return std::ranges::any_of(diagnostics, &Diagnostic::isError);
}

void shift(Diagnostic &diagnostic, std::size_t by)
{
    const auto move = [by](SourceRange &range) { range = {range.begin + by, range.end + by}; };
    move(diagnostic.range);
    if (diagnostic.fix) {
        for (TextEdit &edit : diagnostic.fix->edits) {
            move(edit.range);
        }
    }
    for (Note &note : diagnostic.notes) {
        if (note.file.empty()) {
            move(note.range);
        }
    }
}

void sortByPlace(Diagnostics &diagnostics)
{
    std::ranges::stable_sort(diagnostics, {}, [](const Diagnostic &d) { return d.range.begin; });
}

std::string seenFrom(std::string_view file, std::string_view inner)
{
    if (inner.empty()) {
        return std::string(file);
    }
    const std::size_t slash = file.rfind('/');
    const bool isWhole = inner.starts_with('/') || slash == file.npos;
    return std::string(isWhole ? std::string_view() : file.substr(0, slash + 1)) + std::string(inner);
}

std::string toLines(const Diagnostic &diagnostic, std::string_view file, Places &places)
{
    const TextPosition at = places.at(diagnostic.range.begin);
    std::string text =
        std::format("{}:{}:{}: {}: {}", file, at.line, at.column, name(diagnostic.severity()), diagnostic.message());
    for (const Note &note : diagnostic.notes) {
        text += std::format("\n{}:{}:{}: note: {}", seenFrom(file, note.file), note.position.line, note.position.column,
                            note.message());
    }
    return text;
}

}
