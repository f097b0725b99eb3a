// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "supports.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Squared, how far apart directions are that count as one.
constexpr double sameSquared = 1e-16;
/// Of a length: what is as little against a direction is along it.
constexpr double rounding = 1e-12;
/// Squared, the sine of an angle at which planes are taken for one.
constexpr double flatSquared = 1e-20;

bool areSame(const glm::dvec3 &one, const glm::dvec3 &other)
{
    const glm::dvec3 apart = one - other;
    return glm::dot(apart, apart) <= sameSquared;
}

}

bool Supports::holds(const glm::dvec3 &direction) const
{
    return std::ranges::any_of(m_directions, [&](const glm::dvec3 &held) { return areSame(held, direction); });
}

bool Supports::add(const glm::dvec3 &direction)
{
    const auto same =
        std::ranges::find_if(m_directions, [&](const glm::dvec3 &held) { return areSame(held, direction); });
    if (same != m_directions.end()) {
        *same = direction;
        return true;
    }
    if (m_directions.size() == most) {
        return false;
    }
    m_directions.push_back(direction);
    return true;
}

bool Supports::allows(const glm::dvec3 &v, double error) const
{
    return std::ranges::all_of(m_directions, [&](const glm::dvec3 &n) { return glm::dot(v, n) >= -error; });
}

glm::dvec3 Supports::allowed(const glm::dvec3 &v) const
{
    // The nearest point of a convex cone is v's foot on one of its faces: the inside, a plane, an edge or the tip. Of the
    // feet that are in the cone it is the longest, since all are at right angles to what is missing.
    const double error = rounding * glm::length(v);
    if (allows(v, error)) {
        return v;
    }
    glm::dvec3 best(0.0);
    double longest = 0.0;
    const auto consider = [&](const glm::dvec3 &foot) {
        const double length = glm::dot(foot, foot);
        if (length > longest && allows(foot, error)) {
            best = foot;
            longest = length;
        }
    };
    for (std::size_t i = 0; i < m_directions.size(); ++i) {
        const glm::dvec3 &one = m_directions[i];
        consider(v - glm::dot(v, one) * one);
        for (std::size_t k = 0; k < i; ++k) {
            const glm::dvec3 along = glm::cross(one, m_directions[k]);
            const double square = glm::dot(along, along);
            if (square > flatSquared) {
                consider(glm::dot(v, along) / square * along);
            }
        }
    }
    return best;
}

glm::dvec3 Supports::along(const glm::dvec3 &v) const
{
    // Gram and Schmidt
    glm::dvec3 left = v;
    boost::container::static_vector<glm::dvec3, 3> axes;
    for (glm::dvec3 axis : m_directions) {
        for (const glm::dvec3 &other : axes) {
            axis -= glm::dot(axis, other) * other;
        }
        const double square = glm::dot(axis, axis);
        if (square > flatSquared && axes.size() < 3) {
            axes.push_back(axis / std::sqrt(square));
            left -= glm::dot(left, axes.back()) * axes.back();
        }
    }
    return axes.size() == 3 ? glm::dvec3(0.0) : left;
}

}
