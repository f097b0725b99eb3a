// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measuredparts.h"

#include "core/physics/scenephysics.h"
#include "render/headless/sceneframes.h"

namespace romanesco {

namespace {

/// Where nothing can be drawn, the trial says so.
MeasuredTrial framesOf(const std::shared_ptr<const Scene> &scene, const TrialContext &context)
{
    const auto source = SceneFrames::create(scene, FrameTrial::width, FrameTrial::height);
    if (!source) {
        return FrameTrial{.reason = source.error()};
    }
    return tryFrames(**source, *scene, {}, context);
}

}

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
        return tryTimeSteps(scene.scene, *balls, {}, context);
    case MeasuredPart::Rendering:
        return framesOf(scene.scene, context);
    case MeasuredPart::Depth:
        return tryDepths(*scene.scene, context);
    case MeasuredPart::Digits:
        break;
    }
    return tryDigits(*scene.scene, {}, context);
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
    if (const auto *frames = get<FrameTrial>(MeasuredPart::Rendering)) {
        all.frames = *frames;
    }
    if (const auto *depths = get<DepthTrial>(MeasuredPart::Depth)) {
        all.depths = *depths;
    }
    if (const auto *digits = get<DigitTrial>(MeasuredPart::Digits)) {
        all.digits = *digits;
    }
    return all;
}

}
