// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace romanesco {

/// Points by their place, each no nearer to another than a tolerance: a hashed grid whose cells are wider than the
/// tolerance, so that nearly every search ends in one cell.
class VertexGrid
{
public:
    /// spacing: what points are usually apart, some times the tolerance at least.
    VertexGrid(double tolerance, double spacing);

    /// The number of the first point within the tolerance in each coordinate; a new one where there is none.
    [[nodiscard]] std::uint32_t add(const glm::dvec3 &point);

    [[nodiscard]] const std::vector<glm::dvec3> &points() const { return m_points; }
    [[nodiscard]] std::vector<glm::dvec3> take() { return std::move(m_points); }

private:
    [[nodiscard]] glm::dvec3 cellOf(const glm::dvec3 &point) const;
    [[nodiscard]] std::size_t bucketOf(const glm::dvec3 &cell) const;
    [[nodiscard]] std::uint32_t findIn(std::size_t bucket, const glm::dvec3 &point) const;
    void grow();

    double m_tolerance;
    double m_cellSize;
    std::vector<glm::dvec3> m_points;
    /// The last point of each bucket, and before each point the one that came before it.
    std::vector<std::uint32_t> m_buckets;
    std::vector<std::uint32_t> m_before;
};

}
