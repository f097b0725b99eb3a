// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/formats/scenedescription.h"
#include "core/text/sourcerange.h"
#include "core/text/textedit.h"
#include "sceneplace.h"

namespace romanesco {

/// How a scene is looked at from a place in it, as deep as it may be (a camera in world coordinates ends where copies are
/// 1e-16 of the whole). A text keeps it in a comment, which other programs pass over:
///
///     # view: (1, 2, -9) (0, 0.5, 0) 60 perspective
///     # view: endless, in 0: 0.3 0.7*12 1.4 at (0.1, 0, -0.2) (0, 0.5, 0) 60 perspective
///
/// The camera is written as in an .sdo; after `in` comes a ScenePlace.
struct SavedView {
    /// The node that the camera is counted from, with the world's axes and its own unit (see Anchor); without one it is
    /// the world.
    std::optional<ScenePlace> place;
    /// Without a range.
    SceneDescription::Camera camera;
    /// The depth is not the text's but without end.
    bool isEndless = false;
};

/// As an .sdo has it, with all digits.
[[nodiscard]] std::string cameraLine(const SceneDescription::Camera &camera);

/// The comment, without a line end.
[[nodiscard]] std::string viewLine(const SavedView &view);

/// The first such comment of an .fdo or .sdo text, and where it is, without its line end. Any other comment is no view.
[[nodiscard]] std::optional<std::pair<SavedView, SourceRange>> findView(std::string_view text);

/// What of a text becomes another when a view is kept in it. An .sdo gets the camera in its camera's line, in world
/// coordinates as well as those can say it, and the comment above only where that is not all; any other text gets the comment.
/// Both go to where they are, or to the top.
[[nodiscard]] TextEdits editsToSave(const SavedView &view, const SceneDescription::Camera &inWorld,
                                    std::string_view text, bool isSdo);

}
