// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "polygoncutter.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace romanesco {

std::span<const CornerTriangle> PolygonCutter::cut(std::span<const glm::dvec3> corners)
{
    assert(corners.size() >= 3 && "a polygon has at least three corners");
    m_triangles.clear();
    makeLocal(corners);
    // Newell's: twice the area, whatever corner it is taken from.
    glm::dvec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < m_local.size(); ++i) {
        normal += glm::cross(m_local[i], m_local[i + 1]);
    }
    if (isFan(normal)) {
        for (std::uint32_t i = 1; i + 1 < m_local.size(); ++i) {
            m_triangles.push_back({0, i, i + 1});
        }
    } else {
        flatten(normal);
        cutEars(m_flat, m_triangles);
    }
    assert(m_triangles.size() + 2 == corners.size() && "each triangle takes one corner");
    return m_triangles;
}

void PolygonCutter::makeLocal(std::span<const glm::dvec3> corners)
{
    glm::dvec3 farthest(0.0);
    m_local.clear();
    for (const glm::dvec3 &corner : corners) {
        m_local.push_back(corner - corners[0]);
        farthest = glm::max(farthest, glm::abs(m_local.back()));
    }
    const double size = std::max({farthest.x, farthest.y, farthest.z});
    // So that products neither overflow nor vanish. Of infinite differences no numbers are left.
    const double unit = std::ldexp(1.0, -std::max(std::ilogb(size), -1000));
    for (glm::dvec3 &corner : m_local) {
        corner *= unit;
    }
}

/// Also where what is computed is no number.
bool PolygonCutter::isFan(const glm::dvec3 &normal) const
{
    for (std::size_t i = 1; i + 1 < m_local.size(); ++i) {
        if (glm::dot(glm::cross(m_local[i], m_local[i + 1]), normal) < 0) {
            return false;
        }
    }
    return true;
}

/// Drops the coordinate along which the normal is longest, so that the polygon turns left in the other two.
void PolygonCutter::flatten(const glm::dvec3 &normal)
{
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int first = (dropped + 1) % 3;
    int second = (dropped + 2) % 3;
    if (normal[dropped] < 0) {
        std::swap(first, second);
    }
    m_flat.clear();
    for (const glm::dvec3 &corner : m_local) {
        m_flat.emplace_back(corner[first], corner[second]);
    }
}

}
