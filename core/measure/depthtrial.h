// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "trialcontext.h"

namespace romanesco {

/// How far from its place on the screen a copy stands so many levels down, by the kind of numbers.
struct DepthRow {
    std::size_t depth = 0;

    /// Why it is not known, as a sentence without its end; empty where it is, and only then all that follows means
    /// anything.
    std::string reason = {};
    /// Of the place in the world, in parts of the scene: the logarithm to base 10.
    double sizeLog10 = 0.0;
    /// That are in view.
    std::size_t copies = 0;
    /// The farthest that any point of a copy is off, in pixels; infinite where one is not before the camera at all.
    double inFloat = 0.0;
    double inDouble = 0.0;
    double inFrames = 0.0;
};

/// Copies along one way down a fractal, as they stand on the screen by maps that are composed
///
/// - in float, in the world's coordinates, the camera's map too: the dissertation's way (4.2.4, 4.3.1);
/// - in double, in the world's coordinates, the camera's place taken off before floats are made of it;
/// - in double, counted from a node near by (Anchor), and then floats likewise: this program's way;
///
/// beside the same in 700 digits.
struct DepthTrial {
    /// Of the picture, in pixels; the vertical angle of view is 60 degrees.
    static constexpr int width = 640;
    static constexpr int height = 360;

    /// Why nothing is known, as a sentence; empty where something is.
    std::string reason = {};
    /// By depth.
    std::vector<DepthRow> rows = {};
};

/// Levels down, ascending.
[[nodiscard]] std::span<const std::size_t> trialDepths();

/// Goes down the scene's first fractal by maps that are picked at random, the same ones each time, and looks at all that
/// stands where it comes to, from in front. Where its levels end the whole fractal stands in place of its mesh, so that
/// the way goes on. All is the same in every run. The error is "cancelled". Costs some tenths of a second.
[[nodiscard]] std::expected<DepthTrial, std::string> tryDepths(const Scene &scene, const TrialContext &context = {});

}
