// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "leaffaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>

#include "core/geometry/sizes.h"
#include "core/geometry/triangledistance.h"
#include "nearest.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t mostBlocks = blocksFor(LeafFaces::most);

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

/// What ways in lanes may be off by, of the largest coordinate, or radius, or way.
constexpr double errorOfWays = 64.0 * std::numeric_limits<double>::epsilon();

/// As measureFaces(); reach as seen from the start of the sphere, which is at p. triangleOf(face) as seen from there.
void sweepFaces(std::span<const FaceLanes> faces, std::size_t count, const glm::dvec3 &p, double reach,
                const MovingSphere &sphere, double from, double limit, double slack, const auto &triangleOf,
                SweptFace &found)
{
    found = {.faceTests = count};
    const MovingSphere grown{sphere.direction, sphere.radius + errorOfWays * (reach + sphere.radius + from)};
    std::array<double, LeafFaces::most> lanes;
    const std::span ways = std::span(lanes).first(count);
    waysToFaces(faces, p, grown, from, limit, lanes.data());
    double until = limit;
    for (;;) {
        const std::size_t first = leastOf(ways);
        const double way = std::exchange(ways[first], infinity);
        if (!(way <= until) || way == infinity) {
            found.lower = std::min(found.lower, way);
            return;
        }
        const Triangle triangle = triangleOf(first);
        const TriangleTouch touched = touch(triangle, sphere, way, until);
        found.lower = std::min(found.lower, touched.way);
        if (touched.isTouch && (found.face == Mesh::none || touched.way < found.way)) {
            found.way = touched.way;
            found.face = static_cast<std::uint32_t>(first);
            found.triangle = triangle;
            until = earlierThan(touched.way, slack);
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
    measureFaces(
        m_faces, m_mesh.faces.size(), p, reachFrom(p), limit, motion,
        [&](std::size_t face) { return triangleOf(m_mesh, static_cast<std::uint32_t>(face)); }, hit);
}

void LeafFaces::measure(const AffineMap &map, double limit, const std::optional<glm::dvec3> &motion, LeafHit &hit) const
{
    std::array<FaceLanes, mostBlocks> placed;
    placeFaces(m_corners, map, placed.data());
    measureFaces(
        std::span(placed).first(m_corners.size()), m_mesh.faces.size(), glm::dvec3(0.0), reachOf(map), limit, motion,
        [&](std::size_t face) { return placedTriangle(map, face); }, hit);
}

void LeafFaces::sweep(const glm::dvec3 &start, const MovingSphere &sphere, double from, double limit, double slack,
                      SweptFace &found) const
{
    sweepFaces(
        m_faces, m_mesh.faces.size(), start, reachFrom(start), sphere, from, limit, slack,
        [&](std::size_t face) {
            const Triangle triangle = triangleOf(m_mesh, static_cast<std::uint32_t>(face));
            return Triangle{triangle[0] - start, triangle[1] - start, triangle[2] - start};
        },
        found);
}

void LeafFaces::sweep(const AffineMap &map, const MovingSphere &sphere, double from, double limit, double slack,
                      SweptFace &found) const
{
    std::array<FaceLanes, mostBlocks> placed;
    placeFaces(m_corners, map, placed.data());
    sweepFaces(
        std::span(placed).first(m_corners.size()), m_mesh.faces.size(), glm::dvec3(0.0), reachOf(map), sphere, from,
        limit, slack, [&](std::size_t face) { return placedTriangle(map, face); }, found);
}

double LeafFaces::reachFrom(const glm::dvec3 &p) const
{
    return greatestSize(glm::max(glm::abs(p - m_box.least), glm::abs(m_box.greatest - p)));
}

double LeafFaces::reachOf(const AffineMap &map) const
{
    const glm::dvec3 half = 0.5 * m_box.size();
    return greatestSize(glm::abs(map(m_box.centre())) + glm::abs(map.linear[0]) * half.x
                        + glm::abs(map.linear[1]) * half.y + glm::abs(map.linear[2]) * half.z);
}

Triangle LeafFaces::placedTriangle(const AffineMap &map, std::size_t face) const
{
    const Triangle triangle = triangleOf(m_mesh, static_cast<std::uint32_t>(face));
    return {map(triangle[0]), map(triangle[1]), map(triangle[2])};
}

std::size_t LeafFaces::memoryUse() const
{
    return m_corners.capacity() * sizeof(CornerLanes) + m_faces.capacity() * sizeof(FaceLanes);
}

}
