// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/count.h"
#include "core/scene/scene.h"
#include "frameerror.h"
#include "framesource.h"
#include "spread.h"
#include "trialcontext.h"

namespace romanesco {

/// A pixel tolerance, and what it came to from a place.
struct FrameRow {
    FramePlace place = FramePlace::View;
    /// Pixels.
    double tolerance = 0.0;

    /// Why it was not drawn, as a sentence without its end; empty where it was, and only then all that follows means
    /// anything.
    std::string reason = {};
    /// Of a frame of one sample a pixel that follows another from the same place.
    FrameCost cost = {};
    Spread milliseconds = {};
    /// Of one sample a pixel, as the window draws while the camera moves, off the reference: what that leaves jagged, too.
    FrameError moving = {};
    /// Of as many samples as the reference has, at the same places in the pixel: what the tolerance alone does.
    FrameError alone = {};
};

/// What others are compared with from a place: the least tolerance that was drawn, with many samples a pixel.
struct FrameReference {
    FramePlace place = FramePlace::View;
    double tolerance = 0.0;
    int samples = 0;
    /// Half of its samples beside all: about what it is off a picture of infinitely many.
    FrameError leftover = {};
};

/// Pictures of a scene, drawn with one pixel tolerance after another.
struct FrameTrial {
    /// Of the pictures.
    static constexpr int width = 640;
    static constexpr int height = 360;

    struct Options {
        /// Of a picture of one sample: a tolerance that might take more is not tried. As it is about a second in software.
        std::uint64_t mostOperations = 6'000'000;
        /// Of all pictures from a place: the samples of the reference are fewer where they would take more.
        std::uint64_t mostInAll = 60'000'000;
        /// A power of two.
        int mostSamples = 64;
    };

    /// Why nothing could be drawn, as a sentence; empty where it could, and only then all that follows means anything.
    std::string reason = {};
    /// See FrameSource::description().
    std::string device = {};
    std::vector<FrameReference> references = {};
    /// By place, and from each by tolerance.
    std::vector<FrameRow> rows = {};
};

/// The pixel tolerances that are tried, ascending from 0.
[[nodiscard]] std::span<const double> framePixelTolerances();

/// "0.25 px".
[[nodiscard]] std::string nameOf(const FrameRow &row);

/// Draws a scene at all tolerances, from all places. Counts and errors are the same in every run, times are not. The source
/// draws pictures of FrameTrial's size. The error is a sentence: what the source cannot do, cancelled. Costs some
/// seconds, and where much is seen half a minute.
[[nodiscard]] std::expected<FrameTrial, std::string> tryFrames(FrameSource &source, const Scene &scene,
                                                               const FrameTrial::Options &options,
                                                               const TrialContext &context = {});

}
