// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/physics/ball.h"
#include "core/scene/scene.h"
#include "share.h"
#include "spread.h"
#include "trialcontext.h"

namespace romanesco {

/// A way to step balls, and what it came to. Costs are of a ball and a second that it moves.
struct StepRow {
    bool isAsInDissertation = false;
    /// Seconds; one over a whole number.
    double timeStep = 0.0;
    /// So many were dropped: fewer than there are where they would take too long.
    std::size_t balls = 0;

    double faceTests = 0.0;
    double queries = 0.0;
    /// Of the processor's time; over the balls.
    Spread microseconds = {};

    /// What a ball that loses nothing has gained or lost in the end, in parts of what it fell with.
    double energyMedian = 0.0;
    double energyWorst = 0.0;
    /// How far it was from where it lands, when it was found to touch; in radii, of the balls that did not miss.
    double landingMedian = 0.0;
    double landingWorst = 0.0;
    /// Those that touched nothing at all.
    Share missed = {};
};

/// Balls are dropped on a scene, each by itself, to land at places that are known.
struct StepTrial {
    struct Options {
        std::size_t balls = 200;
        /// The least of the scene's, or 2 % of the diagonal.
        std::optional<double> ballRadius = {};
        /// Of a row, some seconds.
        std::uint64_t mostOperations = 20'000'000;
    };

    double ballRadius = 0.0;
    /// What the balls fall before they land, at most; each at least half of that.
    double height = 0.0;
    /// Three times what that takes at most.
    double seconds = 0.0;
    std::vector<StepRow> rows = {};
};

/// One over the time steps that are tried, ascending.
[[nodiscard]] std::span<const int> trialStepsASecond();

/// "romanesco 1/240", "dissertation 1/60".
[[nodiscard]] std::string nameOf(const StepRow &row);

/// Steps balls as this program does and as the dissertation does, with time steps from 1/30 to 1/960 s. Where a ball lands is
/// found beforehand, down from above the surface by its distance alone; how it falls has a closed form. Counts and errors
/// are the same in every run. The error is a sentence: no surface (see Subject), nothing that a ball lands on, cancelled.
[[nodiscard]] std::expected<StepTrial, std::string> tryTimeSteps(const std::shared_ptr<const Scene> &scene,
                                                                 std::span<const Ball> balls,
                                                                 const StepTrial::Options &options,
                                                                 const TrialContext &context = {});

}
