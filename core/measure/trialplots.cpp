// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "trialplots.h"

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
    TrialPlot plot{isByTime ? "nanoseconds a query" : "face tests a query", "largest error, in parts of the distance"};
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

TrialPlot plotOf(const StepTrial &trial, double StepRow::*error, const char *errorAxis)
{
    TrialPlot plot{"microseconds a ball and second", errorAxis};
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

}

std::vector<TrialPlot> plotsOf(const ColliderTrial &trial, QuerySet set)
{
    return {plotOf(trial, set, true), plotOf(trial, set, false)};
}

std::vector<TrialPlot> plotsOf(const StepTrial &trial)
{
    return {plotOf(trial, &StepRow::energyWorst, "energy off by, at worst"),
            plotOf(trial, &StepRow::landingWorst, "landing off by, at worst, in radii")};
}

}
