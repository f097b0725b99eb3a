// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "placement.h"

#include <algorithm>
#include <cassert>
#include <format>

namespace romanesco {

bool isWritablePath(std::string_view path)
{
    return !path.empty() && path.find_first_of("\"\n\r") == std::string_view::npos;
}

TextEdit withPlacedLines(const SdoSyntax &scene, const std::string &lines)
{
    for (std::size_t i = scene.lineCount(); i-- > 0;) {
        if (scene.line(i).file()) {
            const std::size_t end = scene.map().line(i).end;
            return {{end, end}, lines};
        }
    }
    // What ends with a line end goes on in the line after it.
    const std::string &text = scene.text();
    const bool isLineOpen = !text.empty() && text.back() != '\n' && text.back() != '\r';
    return {{text.size(), text.size()}, (isLineOpen ? lines : lines.substr(1)) + '\n'};
}

TextEdits withPlacedFiles(const SdoSyntax &scene, std::span<const FileToPlace> files)
{
    if (files.empty()) {
        return {};
    }
    assert(std::ranges::all_of(files, isWritablePath, &FileToPlace::path) && "strings have no escapes");
    std::string lines;
    for (const FileToPlace &file : files) {
        lines += std::format("\n{} \"{}\" #", file.isFractal ? 'f' : 'o', file.path);
    }
    return {withPlacedLines(scene, lines)};
}

}
