// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "trialplots.h"

#include <cmath>
#include <optional>
#include <utility>

namespace romanesco {

namespace {

void add(TrialPlot &plot, std::size_t row, PlotPoint point)
{
    if (point.cost > 0.0) {
        plot.points.push_back(std::move(point));
        plot.rows.push_back(row);
    }
}

TrialPlot plotOf(const ColliderTrial &trial, QuerySet set, bool isByTime)
{
    TrialPlot plot{isByTime ? "time" : "face tests", isByTime ? "nanoseconds a query" : "face tests a query",
                   "largest error, in parts of the distance"};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const ColliderRow &row = trial.rows[i];
        if (row.queries == set && row.reason.empty()) {
            add(plot, i,
                {.label = nameOf(row),
                 .group = static_cast<int>(row.kind),
                 .cost = isByTime ? row.nanoseconds.median : row.survey.faceTestsMean,
                 .error = row.survey.worst,
                 .spread = isByTime ? std::optional(row.nanoseconds) : std::nullopt});
        }
    }
    return plot;
}

TrialPlot plotOf(const StepTrial &trial, const char *title, double StepRow::*error, const char *errorAxis)
{
    TrialPlot plot{title, "microseconds a ball and second", errorAxis};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const StepRow &row = trial.rows[i];
        add(plot, i,
            {.label = nameOf(row),
             .group = row.isAsInDissertation ? 2 : 0,
             .cost = row.microseconds.median,
             .error = row.*error,
             .spread = row.microseconds});
    }
    return plot;
}

TrialPlot plotOf(const FrameTrial &trial, FramePlace place, bool isByTime)
{
    TrialPlot plot{isByTime ? "time" : "faces", isByTime ? "milliseconds a picture" : "faces a picture",
                   "RMS error by the tolerance alone, of 255"};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const FrameRow &row = trial.rows[i];
        if (row.place == place && row.reason.empty()) {
            add(plot, i,
                {.label = nameOf(row),
                 .cost = isByTime ? row.milliseconds.median : static_cast<double>(row.cost.faces),
                 .error = row.alone.rms,
                 .spread = isByTime ? std::optional(row.milliseconds) : std::nullopt});
        }
    }
    return plot;
}

}

std::vector<TrialPlot> plotsOf(const ColliderTrial &trial, QuerySet set)
{
    return {plotOf(trial, set, true), plotOf(trial, set, false)};
}

std::vector<TrialPlot> plotsOf(const StepTrial &trial)
{
    return {plotOf(trial, "energy", &StepRow::energyWorst, "energy off by, at worst"),
            plotOf(trial, "landing", &StepRow::landingWorst, "landing off by, at worst, in radii")};
}

std::vector<TrialPlot> plotsOf(const DigitTrial &trial)
{
    constexpr const char *error = "largest error, in parts of the diagonal";
    TrialPlot byBytes{"bytes", "bytes a face", error};
    TrialPlot byTime{"time", "nanoseconds a face", error};
    for (std::size_t i = 0; i < trial.rows.size(); ++i) {
        const DigitRow &row = trial.rows[i];
        PlotPoint point{.label = nameOf(row), .group = row.digits ? 0 : 2, .error = row.worst};
        if (row.bytes && trial.facesInAll) {
            point.cost = std::pow(10.0, row.bytes->log10() - trial.facesInAll->log10());
            add(byBytes, i, point);
        }
        point.cost = row.nanoseconds.median;
        point.spread = row.nanoseconds;
        add(byTime, i, std::move(point));
    }
    return {std::move(byBytes), std::move(byTime)};
}

std::vector<TrialPlot> plotsOf(const FrameTrial &trial, FramePlace place)
{
    return {plotOf(trial, place, true), plotOf(trial, place, false)};
}

}
