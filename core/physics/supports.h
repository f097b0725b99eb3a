// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <span>

#include <boost/container/static_vector.hpp>
#include <glm/vec3.hpp>

namespace romanesco {

/// Directions of length 1, from points of a surface to the centre of a ball that touches there: it cannot move against
/// any of them.
class Supports
{
public:
    static constexpr std::size_t most = 12;

    [[nodiscard]] bool isEmpty() const { return m_directions.empty(); }
    [[nodiscard]] std::size_t count() const { return m_directions.size(); }
    [[nodiscard]] std::span<const glm::dvec3> directions() const { return {m_directions.data(), m_directions.size()}; }

    /// Whether one is the same but for rounding.
    [[nodiscard]] bool holds(const glm::dvec3 &direction) const;

    /// Puts one in, or in the place of the one that is the same. False where there is no room for more.
    bool add(const glm::dvec3 &direction);
    void clear() { m_directions.clear(); }

    /// Keeps those that are wanted.
    template<typename IsWanted>
    void keepIf(IsWanted &&isWanted)
    {
        std::size_t kept = 0;
        for (const glm::dvec3 &direction : m_directions) {
            if (isWanted(direction)) {
                m_directions[kept++] = direction;
            }
        }
        m_directions.resize(kept);
    }

    /// What is left of a velocity or an acceleration: of all vectors x with x·n >= 0 for every direction n, but for
    /// rounding, the nearest to v. It is never longer than v. Cost: the pairs of directions.
    [[nodiscard]] glm::dvec3 allowed(const glm::dvec3 &v) const;

    /// What is left of a velocity that goes neither against nor away from any of them.
    [[nodiscard]] glm::dvec3 along(const glm::dvec3 &v) const;

private:
    [[nodiscard]] bool allows(const glm::dvec3 &v, double error) const;

    boost::container::static_vector<glm::dvec3, most> m_directions;
};

}
