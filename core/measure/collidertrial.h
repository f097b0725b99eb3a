// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/count.h"
#include "core/collide/colliderkind.h"
#include "core/physics/ball.h"
#include "core/scene/scene.h"
#include "spread.h"
#include "survey.h"
#include "trialcontext.h"

namespace romanesco {

/// A way to search, and what it came to on a set of queries.
struct ColliderRow {
    ColliderKind kind = ColliderKind::Exact;
    /// Of Approximate.
    std::optional<double> tolerance = {};
    QuerySet queries = QuerySet::Uniform;

    /// Why it is not possible, as a sentence without its end; empty where it is, and only then all that follows means
    /// anything.
    std::string reason = {};
    Survey survey = {};
    /// Of a query.
    Spread nanoseconds = {};
    Spread buildMilliseconds = {};
    /// Beside the mesh and the graph.
    std::size_t bytes = 0;
};

/// What is measured of a scene, and what comes of it.
struct ColliderTrial {
    struct Options {
        /// In each set.
        std::size_t points = 1'600;
        /// Of the ball that may touch; the least of the balls, or 2 % of the diagonal where there is none.
        std::optional<double> ballRadius = {};
        /// Only what has no more faces, written out, is tried by the kinds that look at every face or write them out.
        std::uint64_t mostFaces = 5'000'000;
        /// Of a way to search on a set: what takes more is asked less, and is not tried where one query takes twice as many.
        /// As it is some one or two seconds.
        std::uint64_t mostOperations = 10'000'000;
    };
    struct Set {
        QuerySet queries = QuerySet::Uniform;
        std::size_t points = 0;
        /// Those of them that touch.
        std::size_t touching = 0;
        /// Left out, since the exact collider could not answer them within its budget.
        std::size_t undecided = 0;
    };

    /// Nothing where they are too many sets to count.
    std::optional<Count> faces = {};
    /// Of the box round the surface.
    double diagonal = 0.0;
    double ballRadius = 0.0;
    std::vector<Set> sets = {};
    /// By set, and in each by kind and tolerance.
    std::vector<ColliderRow> rows = {};
};

/// The tolerances of Approximate that are tried, ascending.
[[nodiscard]] std::span<const double> trialTolerances();

/// "exact", "approximate 0.001".
[[nodiscard]] std::string nameOf(const ColliderRow &row);

/// Tries each kind of collider on the surface of a scene (all that is no ball) against the exact one: queries uniform, near
/// and in pockets, and those that the balls make, where there are any. Counts and errors are the same in every run, times
/// are not.
///
/// The error is a sentence: there is no surface, it has no extent, its coordinates are beyond 10^100, the exact collider
/// cannot be built, cancelled. Costs some seconds, and where faces are many a minute.
[[nodiscard]] std::expected<ColliderTrial, std::string> tryColliders(const std::shared_ptr<const Scene> &scene,
                                                                     std::span<const Ball> balls,
                                                                     const ColliderTrial::Options &options,
                                                                     const TrialContext &context = {});

}
