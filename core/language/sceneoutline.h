// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <vector>

#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"

namespace romanesco {

enum class SceneKind { Camera, Object, Fractal, Ball, Light };

/// One entry of a scene's outline.
struct SceneEntry {
    SceneKind kind = SceneKind::Object;
    /// The file as it is named; empty of cameras and lights.
    std::string name;
    /// What stands for it: the path with its quotes, or the letter.
    SourceRange range;
    /// The line from 0.
    std::size_t line = 0;
    /// Else the whole line is a comment, which would be the entry without its mark.
    bool isShown = true;
};

/// What a scene is made of in the order of the text, and the objects, fractals and balls that are hidden in comments. Cost
/// linear.
[[nodiscard]] std::vector<SceneEntry> outline(const SdoSyntax &syntax);

/// The edit that hides what a line places by making the line a comment, or shows it again. Empty where the line places
/// nothing, or is so already.
[[nodiscard]] TextEdits withVisibility(const SdoSyntax &syntax, std::size_t line, bool isShown);

}
