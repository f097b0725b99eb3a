// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "vertexgrid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace romanesco {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

}

VertexGrid::VertexGrid(double tolerance, double spacing)
    : m_tolerance(tolerance)
    , m_cellSize(std::max(spacing / 4.0, 4.0 * tolerance))
    , m_buckets(std::size_t{1} << 10, none)
{
    assert(m_cellSize > 0.0 && "cells have a size");
}

glm::dvec3 VertexGrid::cellOf(const glm::dvec3 &point) const
{
    return glm::floor(point / m_cellSize);
}

std::size_t VertexGrid::bucketOf(const glm::dvec3 &cell) const
{
    std::uint64_t hash = 0;
    for (int i = 0; i < 3; ++i) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(cell[i] + 0.0)) * 0x9E3779B97F4A7C15u; // -0 is 0
        hash ^= hash >> 29;
    }
    return hash & (m_buckets.size() - 1);
}

std::uint32_t VertexGrid::findIn(std::size_t bucket, const glm::dvec3 &point) const
{
    std::uint32_t found = none;
    for (std::uint32_t at = m_buckets[bucket]; at != none; at = m_before[at]) {
        const glm::dvec3 difference = glm::abs(m_points[at] - point);
        if (std::max({difference.x, difference.y, difference.z}) <= m_tolerance) {
            found = at; // the last of the list came first
        }
    }
    return found;
}

std::uint32_t VertexGrid::add(const glm::dvec3 &point)
{
    // The cells that points within the tolerance can lie in: one, unless the point is near a side.
    const glm::dvec3 least = cellOf(point - m_tolerance);
    const glm::dvec3 greatest = cellOf(point + m_tolerance);
    std::uint32_t found = none;
    for (double x = least.x; x <= greatest.x; ++x) {
        for (double y = least.y; y <= greatest.y; ++y) {
            for (double z = least.z; z <= greatest.z; ++z) {
                found = std::min(found, findIn(bucketOf({x, y, z}), point));
            }
        }
    }
    if (found != none) {
        return found;
    }
    if (m_points.size() >= m_buckets.size()) {
        grow();
    }
    const std::size_t bucket = bucketOf(cellOf(point));
    m_before.push_back(m_buckets[bucket]);
    m_buckets[bucket] = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(point);
    return m_buckets[bucket];
}

void VertexGrid::grow()
{
    m_buckets.assign(4 * m_buckets.size(), none);
    for (std::uint32_t i = 0; i < m_points.size(); ++i) {
        const std::size_t bucket = bucketOf(cellOf(m_points[i]));
        m_before[i] = m_buckets[bucket];
        m_buckets[bucket] = i;
    }
}

}
