// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collidertrial.h"
#include "digittrial.h"
#include "errorplot.h"
#include "frametrial.h"
#include "steptrial.h"

namespace romanesco {

/// Error against cost, of the rows of a trial.
struct TrialPlot {
    /// What tells it from the other plots of the same rows: "time".
    std::string title;
    std::string costAxis;
    std::string errorAxis;
    std::vector<PlotPoint> points = {};
    /// Of each point the trial's row; what is not possible has none, nor what took no time to speak of.
    std::vector<std::size_t> rows = {};
};

/// Of a set of queries: by time, and by face tests, which are the same in every run.
[[nodiscard]] std::vector<TrialPlot> plotsOf(const ColliderTrial &trial, QuerySet set);
/// By time: of the energy, and of where balls land.
[[nodiscard]] std::vector<TrialPlot> plotsOf(const StepTrial &trial);
/// From a place: what the tolerance alone does, by time, and by faces drawn.
[[nodiscard]] std::vector<TrialPlot> plotsOf(const FrameTrial &trial, FramePlace place);
/// The error of vertices by bytes, where those can be counted, and by time.
[[nodiscard]] std::vector<TrialPlot> plotsOf(const DigitTrial &trial);

}
