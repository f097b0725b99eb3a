// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

#include "core/measure/spread.h"
#include "evaluationmodels.h"
#include "tests/bench/render/ourframes.h"

namespace romanesco::bench {

/// What a model takes until it is seen, and to hold.
struct Loading {
    /// By the clock, in milliseconds: from the file to a scene, and from there to the first picture.
    Spread load;
    Spread picture;
    /// Mesh and graph, and what the renderer holds for the picture: buffers and bounds.
    std::size_t modelBytes = 0;
    std::size_t pictureBytes = 0;
};

/// So often the dissertation loads each.
constexpr int attempts = 10;

/// Each attempt reads the file anew, and has nothing left of the one before. The renderer must have drawn something.
[[nodiscard]] Loading loaded(const EvaluationModel &model, OurFrames &frames);

}
