// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sourcerange.h"

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

/// A remark about a text: data, put into words by message().
struct Diagnostic {
    DiagnosticCode code;
    SourceRange range;
    std::vector<std::string> arguments;

    [[nodiscard]] std::string message() const;
    [[nodiscard]] Severity severity() const { return romanesco::severity(code); }
    [[nodiscard]] bool isError() const { return severity() == Severity::Error; }
};

/// The diagnostics of one text, in the order in which they were found.
using Diagnostics = std::vector<Diagnostic>;

[[nodiscard]] bool hasErrors(const Diagnostics &diagnostics);

/// Sorted by place, as people read; the order of equal places is kept.
void sortByPlace(Diagnostics &diagnostics);

/// "tree.fdo:14:41: error: …", the form compilers use. lines is the text that the ranges are of.
class LineMap;
[[nodiscard]] std::string toLine(const Diagnostic &diagnostic, std::string_view file, const LineMap &lines);

}
