// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/formats/fractaldescription.h"
#include "core/scene/scene.h"
#include "render/renderer.h"

namespace romanesco::bench {

/// Where pictures are taken from: all of the fractal (as fittedCamera() has it), in front of a part of it, between its parts.
enum class Place { Far, Near, Inside };
constexpr std::array places{Place::Far, Place::Near, Place::Inside};
constexpr std::array placeNames{"far", "near", "inside"};

struct PictureSize {
    int width;
    int height;
};

/// A fractal as bench_render draws it.
struct Subject {
    /// Of its file: resources/examples/NAME.fdo, or of tests/data/collide where it is none of the examples.
    std::string name;
    /// For people.
    std::string title;
    std::uint64_t depth;
    /// What frames are timed at, and what pictures are compared at.
    PictureSize size{1280, 720};
    PictureSize comparedSize{640, 360};
    std::vector<Place> comparedPlaces{};
    /// Of the picture that others are compared with. Where it is not 0 there are too many copies to draw each.
    double referenceTolerance = 0.0;
    /// At which frames are timed, in pixels.
    std::vector<int> timedTolerances{1, 4};
};

/// At which pictures are compared, in pixels.
constexpr std::array tolerances{0, 1, 2, 4, 8};

/// Benchmarks have these names: ours by the tolerance, and "flattened".
[[nodiscard]] std::string runName(const std::string &name, std::uint64_t depth, Place place, const std::string &kind);
/// Of what is only drawn from far at a tolerance of 1.
[[nodiscard]] std::string depthRunName(const std::string &name, std::uint64_t depth);

/// A text to be drawn.
struct FractalText {
    std::filesystem::path path;
    std::string text;

    [[nodiscard]] FractalDescription description() const;
    [[nodiscard]] std::shared_ptr<const Scene> scene() const;
};
/// Ends the program where it cannot be read.
[[nodiscard]] FractalText fractalText(const std::string &name, std::uint64_t depth);

/// One sample, on a plain background.
[[nodiscard]] View viewOf(const std::string &name, const Scene &scene, Place place, const PictureSize &size,
                          double tolerance);

}
