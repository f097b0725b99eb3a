// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <vector>

#include "core/collide/collider.h"

namespace romanesco::bench {

/// Points, and the nearest points of a surface to them: their distances and the directions from there, both empty where
/// they are not known.
struct Answered {
    std::vector<glm::dvec3> points;
    std::vector<double> distances;
    std::vector<glm::dvec3> directions;
};

/// As that collider answers.
[[nodiscard]] Answered answered(const Collider &exact, std::vector<glm::dvec3> points);

/// Of every query, since rare ones would not end on deep fractals; as much as physics has.
constexpr std::uint64_t nodeBudget = 100'000;

/// What answers took, and how many of them were wrong. Shares are of all answers.
struct Survey {
    struct Cost {
        double mean = 0.0;
        /// 99 of 100 answers took no more.
        double p99 = 0.0;
    };
    Cost faceTests;
    Cost nodeVisits;
    /// Off by more than these parts of the distance.
    static constexpr std::array wrongBy{1e-6, 0.01, 0.1};
    std::array<double, wrongBy.size()> wrong{};
    /// The surface is within reach, and what was found is not.
    double missed = 0.0;
    /// The direction is off by more than 10 degrees.
    double turned = 0.0;
    /// Ended by the budget, of those that look at it.
    double cutOff = 0.0;
    /// Bytes that a search held after all queries.
    std::size_t searchBytes = 0;
};

/// Asks for the first `most` of them.
[[nodiscard]] Survey survey(const Collider &collider, const Answered &truth, double reach, std::size_t most);

}
