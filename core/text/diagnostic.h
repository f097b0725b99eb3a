// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sourcerange.h"
#include "textedit.h"
#include "textposition.h"

namespace romanesco {

enum class Severity { Error, Warning, Hint };

/// One for each row of diagnostics.def.
enum class DiagnosticCode {
#define DIAGNOSTIC(code, name, severity, words) code,
#include "diagnostics.def"
#undef DIAGNOSTIC
};

/// The row's name in machine-readable output ("unknown-name"), stable between versions.
[[nodiscard]] std::string_view name(DiagnosticCode code);
[[nodiscard]] Severity severity(DiagnosticCode code);
/// "error", "warning", "hint".
[[nodiscard]] std::string_view name(Severity severity);

/// The row's words with the arguments in their places.
[[nodiscard]] std::string message(DiagnosticCode code, const std::vector<std::string> &arguments);

/// A way to put right what is remarked on, offered as an action: "Insert the missing ]".
struct Fix {
    std::string title;
    TextEdits edits;
};
[[nodiscard]] Fix insertion(std::string title, std::size_t at, std::string text);
[[nodiscard]] Fix replacement(std::string title, SourceRange range, std::string text);

/// Another place that a diagnostic is about, such as where a name is declared already.
struct Note {
    DiagnosticCode code;
    SourceRange range;
    std::vector<std::string> arguments;
    /// The file that the range is of, as the text names it; empty for the text itself.
    std::string file;
    /// Where the range begins.
    TextPosition position;

    [[nodiscard]] std::string message() const { return romanesco::message(code, arguments); }
};

/// A remark about a text: data, put into words by message().
struct Diagnostic {
    DiagnosticCode code;
    SourceRange range;
    std::vector<std::string> arguments;
    std::optional<Fix> fix = std::nullopt;
    std::vector<Note> notes = {};

    [[nodiscard]] std::string message() const { return romanesco::message(code, arguments); }
    [[nodiscard]] Severity severity() const { return romanesco::severity(code); }
    [[nodiscard]] bool isError() const { return severity() == Severity::Error; }
};

/// The diagnostics of one text, in the order in which they were found.
using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool hasErrors(const Diagnostics &diagnostics);

/// Moves all places in the text itself by so many bytes, as when a line was read by itself.
void shift(Diagnostic &diagnostic, std::size_t by);

/// Sorted by place, as people read; the order of equal places is kept.
void sortByPlace(Diagnostics &diagnostics);

class Places;

/// A file that a text in another file names, as seen from where that one is named: "scenes/tree.fdo" for "tree.fdo" in
/// "scenes/wood.sdo".
[[nodiscard]] std::string seenFrom(std::string_view file, std::string_view inner);

/// "tree.fdo:14:41: error: …", the form compilers use; each note is one more such line. places are those of the
/// text that the ranges are of.
[[nodiscard]] std::string toLines(const Diagnostic &diagnostic, std::string_view file, Places &places);

}
