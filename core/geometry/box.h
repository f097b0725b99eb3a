// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace romanesco {

/// An axis-aligned box, from least to greatest corner; of nothing where the least is above the greatest.
struct Box {
    glm::dvec3 least{0.0};
    glm::dvec3 greatest{0.0};

    [[nodiscard]] static Box ofNothing()
    {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        return {glm::dvec3(infinity), glm::dvec3(-infinity)};
    }
    [[nodiscard]] bool isEmpty() const { return glm::any(glm::greaterThan(least, greatest)); }

    [[nodiscard]] glm::dvec3 centre() const { return 0.5 * least + 0.5 * greatest; }
    [[nodiscard]] glm::dvec3 size() const { return greatest - least; }

    /// The smallest box round both.
    [[nodiscard]] Box with(const Box &other) const
    {
        return {glm::min(least, other.least), glm::max(greatest, other.greatest)};
    }
    [[nodiscard]] Box with(const glm::dvec3 &point) const { return with(Box{point, point}); }

    /// What is in both.
    [[nodiscard]] Box within(const Box &other) const
    {
        return {glm::max(least, other.least), glm::min(greatest, other.greatest)};
    }
};

}
