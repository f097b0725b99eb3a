// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"

namespace romanesco {

/// A file to be placed in a scene.
struct FileToPlace {
    /// As the text writes it: with `/`, without the quotes.
    std::string path;
    /// An .fdo; else an .obj.
    bool isFractal = false;
};

/// Whether a path can be written: strings have no escapes.
[[nodiscard]] bool isWritablePath(std::string_view path);

/// The edit that adds lines, each of which begins with a line end, to what a scene places: after the last line that places
/// something, or at the end of the text.
[[nodiscard]] TextEdit withPlacedLines(const SdoSyntax &scene, const std::string &lines);

/// The edit that places files in a scene as they are, each by a line of its own: after the last line that places one, or at
/// the end of the text. Paths are writable; none is no edit.
[[nodiscard]] TextEdits withPlacedFiles(const SdoSyntax &scene, std::span<const FileToPlace> files);

}
