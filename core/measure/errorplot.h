// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spread.h"

namespace romanesco {

/// A way to do something: what it costs, and how far off it is.
struct PlotPoint {
    std::string label;
    /// Points of a group have a colour; from 0 to 5.
    int group = 0;
    /// Above 0.
    double cost = 1.0;
    /// From 0 on.
    double error = 0.0;
    /// Of the cost.
    std::optional<Spread> spread = {};
};

/// Those that no other point beats: that costs no more and is no farther off, and one of both less. Beside the points.
[[nodiscard]] std::vector<bool> paretoFront(std::span<const PlotPoint> points);

/// An SVG picture of error against cost, both by their logarithms; what is not off at all stands at the bottom. Points on
/// the front are full, and joined. Empty without points.
[[nodiscard]] std::string errorPlot(std::span<const PlotPoint> points, const std::string &costAxis,
                                    const std::string &errorAxis);

/// A text as it stands in HTML and SVG.
[[nodiscard]] std::string escaped(std::string_view text);

}
