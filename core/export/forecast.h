// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>

#include "core/base/count.h"
#include "core/scene/scene.h"
#include "exportoptions.h"

namespace romanesco {

/// What an export comes to, before welding.
struct ExportForecast {
    /// Exact: those of the distinct copies (see instancesDistinct()), which are what is written.
    Count vertices;
    Count faces;
    /// Within 2 %.
    Count bytes;
};

/// Cost: milliseconds, at any size. The lengths of numbers are those of copies drawn at random, with a seed that is
/// always the same. Nothing where the copies cannot be counted.
[[nodiscard]] std::optional<ExportForecast> forecast(const Scene &scene, const ExportOptions &options);

}
