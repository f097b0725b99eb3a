// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>
#include <vector>

#include "core/measure/collidertrial.h"
#include "evaluationmodels.h"
#include "loading.h"
#include "shrinkingball.h"

namespace romanesco::bench {

/// What was measured of a model.
struct Evaluated {
    EvaluationModel model;
    Loading loading;
    ColliderTrial colliders;
};

/// Of all that is tried, what the page shows.
[[nodiscard]] bool isShown(const ColliderRow &row);

/// The parts of docs/evaluation.md, in Markdown.
[[nodiscard]] std::string introduction(const std::string &machine);
[[nodiscard]] std::string loadingSection(const std::vector<Evaluated> &evaluated);
[[nodiscard]] std::string collisionSection(const std::vector<Evaluated> &evaluated);
[[nodiscard]] std::string shrinkingSection(const ShrinkingGround &ground, const ShrinkingTrial &trial,
                                           const PicturedBall &pictured);
[[nodiscard]] std::string leftOutSection();

}
