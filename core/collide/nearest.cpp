// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "nearest.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace romanesco {

bool NearestFace::consider(const AffineMap &modelFromBase, Counted counted, std::vector<glm::dvec3> &scratch)
{
    scratch.resize(m_mesh.vertices.size());
    std::ranges::transform(m_mesh.vertices, scratch.begin(), modelFromBase);
    bool isNearer = false;
    for (std::size_t i = 0; i < m_mesh.faces.size(); ++i) {
        const Mesh::Face &face = m_mesh.faces[i];
        const Triangle triangle{scratch[face[0]], scratch[face[1]], scratch[face[2]]};
        const ClosestPoint point = closestPoint(triangle, m_query.p);
        if (counted == Counted::Ahead && !isAhead(point.point, triangle, m_query.p, m_query.motion)) {
            continue;
        }
        m_lower = std::min(m_lower, point.lower);
        if (point.distance < m_nearest.distance) {
            m_nearest = point;
            m_triangle = triangle;
            m_face = static_cast<std::uint32_t>(i);
            isNearer = true;
        }
    }
    m_faceTests += m_mesh.faces.size();
    return isNearer;
}

void NearestFace::restart()
{
    m_nearest = nothing;
    m_lower = nothing.lower;
}

glm::dvec3 contactDirection(const glm::dvec3 &point, const Triangle &triangle, const glm::dvec3 &p,
                            const std::optional<glm::dvec3> &motion)
{
    // scaled, since squares of small numbers underflow
    const auto direction = [](const glm::dvec3 &along) -> std::optional<glm::dvec3> {
        const double size = std::max({std::abs(along.x), std::abs(along.y), std::abs(along.z)});
        return size > 0.0 ? std::optional(glm::normalize(along / size)) : std::nullopt;
    };
    if (const auto way = direction(p - point)) {
        return *way;
    }
    const auto against = motion ? direction(-*motion) : std::nullopt;
    const auto normal = direction(glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
    if (!normal) {
        return against.value_or(glm::dvec3(0.0, 1.0, 0.0));
    }
    return against && glm::dot(*normal, *against) < 0.0 ? -*normal : *normal;
}

bool isAhead(const glm::dvec3 &point, const Triangle &triangle, const glm::dvec3 &p,
             const std::optional<glm::dvec3> &motion)
{
    return !motion || glm::dot(contactDirection(point, triangle, p, motion), *motion) < 0.0;
}

void place(Hit &hit, const ClosestPoint &nearest, const Triangle &triangle, const glm::dvec3 &p,
           const std::optional<glm::dvec3> &motion)
{
    hit.distance = nearest.distance;
    hit.point = nearest.point;
    hit.direction = contactDirection(nearest.point, triangle, p, motion);
}

void report(const NearestFace &nearest, const Query &query, Promise promise, Hit &hit)
{
    hit.promise = promise;
    hit.excess = 0.0;
    hit.lower = promise == Promise::Exact ? nearest.lower() : 0.0;
    hit.cost.faceTests = nearest.faceTests();
    hit.distance = std::numeric_limits<double>::infinity();
    if (nearest.nearest().distance <= query.radius) {
        place(hit, nearest.nearest(), nearest.triangle(), query.p, query.motion);
        hit.face = nearest.face();
    }
}

}
