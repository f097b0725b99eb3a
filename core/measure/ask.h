// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <limits>
#include <stop_token>
#include <variant>

#include "core/collide/collider.h"

namespace romanesco {

/// Nodes that a question may visit, as physics allows: rare ones would not end on a deep fractal.
constexpr std::uint64_t askBudget = 100'000;

/// A question to a collider: of the nearest point, or of a first touch.
struct Ask {
    std::variant<Query, Sweep> what;
    /// What is found nearer to a query's place is a collision.
    double reach = std::numeric_limits<double>::infinity();
};

/// What is compared of an answer.
struct Answer {
    /// Of a query the distance, or its radius where nothing is within; of a sweep how far the sphere's front comes from where its centre started, on
    /// its free way.
    double length = 0.0;
    bool touches = false;
    bool isExact = false;
    SearchCost cost = {};
};

/// Asks a collider, one question after another. The collider must outlive it.
class Asker
{
public:
    explicit Asker(const Collider &collider)
        : m_search(collider.search())
    {
    }

    /// Once a stop is asked for, an answer means nothing.
    [[nodiscard]] Answer operator()(const Ask &ask, const std::stop_token &stop = {});

private:
    std::unique_ptr<Search> m_search;
    Hit m_hit;
    Touch m_touch;
};

/// What lengths may be off by for rounding, and for what sweeps leave open, where the surface's coordinates are at most so
/// large, either way.
[[nodiscard]] double roundingOf(const Ask &ask, double size);

}
