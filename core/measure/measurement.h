// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <optional>
#include <string>

#include "collidertrial.h"
#include "depthtrial.h"
#include "digittrial.h"
#include "frametrial.h"
#include "steptrial.h"

namespace romanesco {

/// What was measured of a scene.
struct Measurement {
    /// What the scene is called.
    std::string source;
    ColliderTrial colliders;
    /// Where it is asked for.
    std::optional<StepTrial> steps = {};
    std::optional<FrameTrial> frames = {};
    /// Beside frames.
    std::optional<DepthTrial> depths = {};
    std::optional<DigitTrial> digits = {};
};

}
