// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/physics/ball.h"
#include "core/physics/surface.h"
#include "core/scene/scene.h"

namespace romanesco::bench {

/// A fractal of tests/data/collide as a ground to fall on, scaled to a diagonal of `size`, its middle at the origin.
struct Ground {
    static constexpr double size = 10.0;

    std::shared_ptr<const Scene> scene;
    /// Written out, in the world.
    Mesh all;
    Box box;
    /// Of the graph and its boxes.
    double seconds;
    std::size_t bytes;
};

/// Turned by angles about x, y and z, in degrees. Ends the program where it cannot be read.
[[nodiscard]] Ground groundOf(const std::string &name, std::uint64_t depth, const glm::dvec3 &angles);

/// The same in a tray, which keeps balls from falling off; the tray is not in `all`.
[[nodiscard]] Ground inTray(Ground ground);

/// How balls start: at rest above the ground, anywhere up to a tenth of its size; in layers there, so that none overlap; or
/// from all around towards it.
enum class Start { Drop, Rain, Shot };

/// The same each time. speed: of a shot.
[[nodiscard]] std::vector<Ball> ballsOver(const Ground &ground, Start start, double radius, std::size_t count,
                                          double speed = 0.0);

}
