// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>

#include "collidertrial.h"

namespace romanesco {

/// What was measured of a scene.
struct Measurement {
    /// What the scene is called.
    std::string source;
    ColliderTrial colliders;
};

}
