// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include <glm/vec3.hpp>

#include "core/formats/sdosyntax.h"
#include "core/text/textedit.h"

namespace romanesco {

/// A ball that is to be written where it is.
struct KeptBall {
    /// Which of the scene's own it is, from 0 in the order of the text; none for another.
    std::optional<std::size_t> own;
    glm::dvec3 position{0.0};
    glm::dvec3 velocity{0.0};
    /// Of its mesh: of the scene's own times what the text has.
    double scale = 1.0;
    double restitution = 1.0;
};

/// How many balls a scene has.
[[nodiscard]] std::size_t ballCount(const SdoSyntax &scene);

/// The edit that writes balls into a sound scene: the lines of its own are changed where they are other than they say, and go
/// with balls that are not there; others follow the last line that places something, as the mesh of that path, which is
/// writable. Balls are in order, its own first.
[[nodiscard]] TextEdits withBalls(const SdoSyntax &scene, std::span<const KeptBall> balls, std::string_view path);

}
