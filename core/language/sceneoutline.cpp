// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "sceneoutline.h"

#include <algorithm>
#include <optional>

#include "core/text/lexer.h"

namespace romanesco {

namespace {

std::optional<SceneKind> kindOf(const SdoLine &line)
{
    // In the order of the variant, after nothing.
    const std::size_t index = line.declaration.index();
    return index > 0 ? std::optional(static_cast<SceneKind>(index - 1)) : std::nullopt;
}

/// What a comment holds, and the mark before it.
struct Hidden {
    SourceRange mark;
    SdoLine line;
};

/// Of a line that is a comment and would place a file without an error.
std::optional<Hidden> hiddenIn(const SdoSyntax &syntax, std::size_t number)
{
    const std::string_view text = syntax.map().lineText(number);
    const std::size_t hash = text.find_first_not_of(blanks, syntax.skipped(number));
    if (hash == text.npos || text[hash] != '#') {
        return std::nullopt;
    }
    const std::size_t end = hash + (text.substr(hash).starts_with("# ") ? 2 : 1);
    // Its ranges count from the start of the line.
    SdoLine line = parseSdoLine(text, end);
    const std::size_t start = syntax.map().start(number);
    if (!line.file() || line.isBad || !line.diagnostics.empty()) {
        return std::nullopt;
    }
    return Hidden{{start + hash, start + end}, std::move(line)};
}

SceneEntry entryOf(const SdoSyntax &syntax, std::size_t number, const SdoLine &line, SceneKind kind, bool isShown)
{
    const std::string_view text = syntax.text();
    const PlacedFile *file = line.file();
    SourceRange range = syntax.range(number, file ? file->path : line.range);
    if (!file) {
        range.end = std::min(range.begin + 1, range.end);
    }
    std::string name;
    if (file && range.length() >= 2) {
        name = text.substr(range.begin + 1, range.length() - 2);
    }
    return {kind, std::move(name), range, number, isShown};
}

}

std::vector<SceneEntry> outline(const SdoSyntax &syntax)
{
    std::vector<SceneEntry> entries;
    for (std::size_t number = 0; number < syntax.lineCount(); ++number) {
        const SdoLine &line = syntax.line(number);
        if (const std::optional<SceneKind> kind = kindOf(line)) {
            entries.push_back(entryOf(syntax, number, line, *kind, true));
        } else if (const std::optional<Hidden> hidden = hiddenIn(syntax, number)) {
            entries.push_back(entryOf(syntax, number, hidden->line, *kindOf(hidden->line), false));
        }
    }
    return entries;
}

TextEdits withVisibility(const SdoSyntax &syntax, std::size_t line, bool isShown)
{
    if (line >= syntax.lineCount()) {
        return {};
    }
    if (!isShown && syntax.line(line).file()) {
        const std::size_t begin = syntax.range(line, syntax.line(line).range).begin;
        return {{{begin, begin}, "# "}};
    }
    const std::optional<Hidden> hidden = isShown ? hiddenIn(syntax, line) : std::nullopt;
    return hidden ? TextEdits{{hidden->mark, ""}} : TextEdits{};
}

}
