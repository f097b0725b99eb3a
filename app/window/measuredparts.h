// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <QString>

#include "core/measure/measurement.h"

namespace romanesco {

/// What is measured of a scene, each by itself.
enum class MeasuredPart { Colliders, TimeStep, Rendering, Depth, Digits };
inline constexpr std::array measuredParts{MeasuredPart::Colliders, MeasuredPart::TimeStep, MeasuredPart::Rendering,
                                          MeasuredPart::Depth, MeasuredPart::Digits};

/// What is measured, as it was when that began.
struct MeasuredScene {
    /// Not null.
    std::shared_ptr<const Scene> scene;
    /// Those that are there now; nothing for the scene's own.
    std::optional<std::vector<Ball>> balls;
    /// Of its text.
    QString name;
};

/// What a part came to; the error is a sentence without its end.
using MeasuredTrial =
    std::expected<std::variant<ColliderTrial, StepTrial, FrameTrial, DepthTrial, DigitTrial>, std::string>;

/// Costs seconds; a stop is heard as TrialContext says.
[[nodiscard]] MeasuredTrial measurePart(MeasuredPart part, const MeasuredScene &scene, const TrialContext &context);

/// What was measured of a scene so far.
struct MeasuredParts {
    MeasuredScene of;
    /// By part; nothing where that was not measured.
    std::array<std::optional<MeasuredTrial>, measuredParts.size()> trials = {};

    [[nodiscard]] const std::optional<MeasuredTrial> &trial(MeasuredPart part) const
    {
        return trials[static_cast<std::size_t>(part)];
    }
    /// Null where there is none.
    template<typename Trial>
    [[nodiscard]] const Trial *get(MeasuredPart part) const
    {
        const auto &made = trial(part);
        return made && *made ? std::get_if<Trial>(&**made) : nullptr;
    }
    /// All of it, for a page; nothing without colliders.
    [[nodiscard]] std::optional<Measurement> measurement() const;
};

}
