// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "surface.h"

namespace romanesco {

/// What the questions of a step may take. Counts, so that steps do not depend on the machine.
struct ProbeBudget {
    std::uint64_t nodes = 100'000;
    unsigned queries = 10'000;
};

/// Asks about a surface on behalf of one ball after another. One for each thread; the surface must outlive it.
class Probe
{
public:
    explicit Probe(const Surface &surface);

    /// For the next step of a ball.
    void begin(const ProbeBudget &budget);
    [[nodiscard]] bool isExhausted() const { return m_left.nodes == 0 || m_left.queries == 0; }
    [[nodiscard]] const SearchCost &cost() const { return m_cost; }
    [[nodiscard]] unsigned queries() const { return m_queries; }

    /// What lengths near a point may be off by.
    [[nodiscard]] double roundingAt(const glm::dvec3 &p) const;
    [[nodiscard]] const Surface &surface() const { return m_surface; }

    /// What was found last: direction and whether there is anything; and how near the surface is at least.
    struct Nearest {
        bool isFound = false;
        double clearance = 0.0;
        double distance = 0.0;
        glm::dvec3 direction{0.0, 1.0, 0.0};
    };
    /// The nearest point within a radius; with a motion, of what that comes nearer to.
    [[nodiscard]] Nearest nearest(const glm::dvec3 &p, double radius,
                                  const std::optional<glm::dvec3> &motion = std::nullopt);

    /// Which share of a straight way a sphere goes before it touches; 1 for all of it.
    [[nodiscard]] double freeShare(const glm::dvec3 &from, const glm::dvec3 &way, double radius);

private:
    void count(const SearchCost &cost);

    const Surface &m_surface;
    std::unique_ptr<Search> m_search;
    ProbeBudget m_left;
    SearchCost m_cost;
    unsigned m_queries = 0;
    Hit m_hit;
    Touch m_touch;
};

}
