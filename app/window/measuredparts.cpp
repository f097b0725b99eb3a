// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measuredparts.h"

#include "core/physics/scenephysics.h"

namespace romanesco {

MeasuredTrial measurePart(MeasuredPart part, const MeasuredScene &scene, const TrialContext &context)
{
    const auto balls = scene.balls ? *scene.balls : ballsOf(*scene.scene);
    if (!balls) {
        return std::unexpected(balls.error());
    }
    switch (part) {
    case MeasuredPart::Colliders:
        return tryColliders(scene.scene, *balls, {}, context);
    case MeasuredPart::TimeStep:
        break;
    }
    return tryTimeSteps(scene.scene, *balls, {}, context);
}

std::optional<Measurement> MeasuredParts::measurement() const
{
    const auto *colliders = get<ColliderTrial>(MeasuredPart::Colliders);
    if (!colliders) {
        return std::nullopt;
    }
    Measurement all{.source = of.name.toStdString(), .colliders = *colliders};
    if (const auto *steps = get<StepTrial>(MeasuredPart::TimeStep)) {
        all.steps = *steps;
    }
    return all;
}

}
