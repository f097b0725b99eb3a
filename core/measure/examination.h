// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ask.h"
#include "core/geometry/box.h"
#include "core/physics/ball.h"
#include "core/scene/scene.h"
#include "queryset.h"
#include "trialcontext.h"

namespace romanesco {

/// Questions about a surface, with the exact answers. The same every time.
struct Examination {
    QuerySet queries = QuerySet::Uniform;
    std::vector<Ask> asks = {};
    /// Beside the questions, each exact.
    std::vector<Answer> answers = {};
    /// The greatest coordinate of the surface, either way.
    double size = 0.0;
    /// Questions that the exact collider could not answer within their budget, which are not among them.
    std::size_t undecided = 0;
};

/// What is asked about.
struct Subject {
    std::shared_ptr<const Scene> scene;
    /// That fall on it.
    std::span<const Ball> balls;
    /// Of all that is no ball: objects and fractals with faces.
    std::vector<SceneItem> surface = {};
    Box box = {};
    /// Of the box.
    double diagonal = 0.0;

    /// The error is a sentence: there is no surface, it has no extent, its coordinates are beyond 10^100.
    [[nodiscard]] static std::expected<Subject, std::string> of(std::shared_ptr<const Scene> scene,
                                                                std::span<const Ball> balls);
};

/// Of the least ball, or 2 % of the diagonal where there is none.
[[nodiscard]] double defaultBallRadius(const Subject &subject);

/// Operations that an answer took, of all kinds: a node costs about as much as four faces.
[[nodiscard]] std::uint64_t operationsOf(const SearchCost &cost);

/// So many questions of each set, or fewer where they would take too long: uniform, near and in pockets, where a ball of a
/// radius may collide; and what the balls ask, where there are any. The error is a sentence: what the exact collider
/// cannot do, cancelled. Costs some tenths of a second.
[[nodiscard]] std::expected<std::vector<Examination>, std::string>
examinations(const Subject &subject, std::size_t points, double ballRadius, const TrialContext &context = {});

}
