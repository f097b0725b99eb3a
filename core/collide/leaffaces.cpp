// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "leaffaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "core/geometry/triangledistance.h"
#include "nearest.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t mostBlocks = blocksFor(LeafFaces::most);

double largest(const glm::dvec3 &v)
{
    return std::max({v.x, v.y, v.z});
}

/// Distances of faces that are not ahead become infinite, as far as they are looked at.
std::size_t nearestAhead(std::span<double> distances, double limit, const glm::dvec3 &p,
                         const std::optional<glm::dvec3> &motion, const auto &triangleOf)
{
    std::size_t best = leastOf(distances);
    while (motion && distances[best] <= limit && distances[best] < infinity) {
        const Triangle triangle = triangleOf(best);
        if (isAhead(closestPoint(triangle, p).point, triangle, p, motion)) {
            break;
        }
        distances[best] = infinity;
        best = leastOf(distances);
    }
    return best;
}

/// triangleOf(face) as it is placed. reach: no coordinate of a corner, seen from p, is larger.
void measureFaces(std::span<const FaceLanes> faces, std::size_t count, const glm::dvec3 &p, double reach, double limit,
                  const std::optional<glm::dvec3> &motion, const auto &triangleOf, LeafHit &hit)
{
    std::array<double, LeafFaces::most> lanes;
    const std::span distances = std::span(lanes).first(count);
    faceDistances(faces, p, lanes.data());
    for (std::size_t i = 0; i < count; ++i) {
        if (faces[i / laneCount].isPlain[i % laneCount] == 0.0 || !(reach < 1e70)) {
            distances[i] = distanceTo(triangleOf(i), p).distance;
        }
    }
    const double error = errorOfFaceDistances * reach;
    const std::size_t best = nearestAhead(distances, limit + error, p, motion, triangleOf);
    const double nearest = std::max(distances[best] - error, 0.0);
    hit.face = Mesh::none;
    hit.lower = nearest;
    hit.faceTests = count;
    if (nearest <= limit && distances[best] < infinity) {
        hit.face = static_cast<std::uint32_t>(best);
        hit.triangle = triangleOf(best);
        hit.distance = distances[best];
        if (hit.distance + error > limit) {
            hit.distance = closestPoint(hit.triangle, p).distance;
        }
    }
}

}

LeafFaces::LeafFaces(const Mesh &mesh)
    : m_mesh(mesh)
    , m_box(Box::ofNothing())
{
    if (mesh.faces.empty() || mesh.faces.size() > most) {
        return;
    }
    for (const Mesh::Face &face : mesh.faces) {
        for (const std::uint32_t vertex : face) {
            m_box = m_box.with(mesh.vertices[vertex]);
        }
    }
    m_corners = cornersOf(mesh);
    m_faces.resize(m_corners.size());
    placeFaces(m_corners, {}, m_faces.data());
}

void LeafFaces::measure(const glm::dvec3 &p, double limit, const std::optional<glm::dvec3> &motion, LeafHit &hit) const
{
    const double reach = largest(glm::max(glm::abs(p - m_box.least), glm::abs(m_box.greatest - p)));
    measureFaces(
        m_faces, m_mesh.faces.size(), p, reach, limit, motion,
        [&](std::size_t face) { return triangleOf(m_mesh, static_cast<std::uint32_t>(face)); }, hit);
}

void LeafFaces::measure(const AffineMap &map, double limit, const std::optional<glm::dvec3> &motion, LeafHit &hit) const
{
    std::array<FaceLanes, mostBlocks> placed;
    placeFaces(m_corners, map, placed.data());
    const glm::dvec3 half = 0.5 * m_box.size();
    const glm::dvec3 reach = glm::abs(map(m_box.centre())) + glm::abs(map.linear[0]) * half.x
        + glm::abs(map.linear[1]) * half.y + glm::abs(map.linear[2]) * half.z;
    const auto placedTriangle = [&](std::size_t face) {
        Triangle triangle = triangleOf(m_mesh, static_cast<std::uint32_t>(face));
        for (glm::dvec3 &vertex : triangle) {
            vertex = map(vertex);
        }
        return triangle;
    };
    measureFaces(std::span(placed).first(m_corners.size()), m_mesh.faces.size(), glm::dvec3(0.0), largest(reach), limit,
                 motion, placedTriangle, hit);
}

std::size_t LeafFaces::memoryUse() const
{
    return m_corners.capacity() * sizeof(CornerLanes) + m_faces.capacity() * sizeof(FaceLanes);
}

}
