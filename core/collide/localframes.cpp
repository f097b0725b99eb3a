// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "localframes.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/similarity.h"
#include "nearest.h"

namespace romanesco {

namespace {

/// What a step may put p off by, of the numbers that are added: nine products and sums, with factors that are rounded.
constexpr double errorOfStep = 8.0 * std::numeric_limits<double>::epsilon();

double sumOfSizes(const glm::dvec3 &v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

double distanceToBox(const glm::dvec3 &p, const glm::dvec3 &least, const glm::dvec3 &greatest)
{
    return glm::length(glm::max(glm::max(least - p, p - greatest), glm::dvec3(0.0)));
}

}

std::optional<LocalFrames::Inverses> LocalFrames::inverses(const FractalGraph &graph)
{
    Inverses inverses(graph.setCount());
    for (SetId set = 0; set < graph.setCount(); ++set) {
        for (const AffineMap &map : graph.set(set).maps) {
            const std::optional<Similarity> similarity = similarityOf(map);
            if (!similarity) {
                return std::nullopt;
            }
            const auto &[forward, inverse, scale] = *similarity;
            inverses[set].push_back({inverse, {inverse.linear * scale, inverse.translation * scale}, scale});
        }
    }
    return inverses;
}

LocalFrames::LocalFrames(const FractalGraph &graph, const Inverses &inverses, const Mesh &mesh, const FaceTree &tree)
    : m_graph(graph)
    , m_inverses(inverses)
    , m_mesh(mesh)
    , m_leaf(mesh, tree)
{
    for (const std::vector<Inverse> &ofSet : inverses) {
        double &farthest = m_farthest.emplace_back(0.0);
        for (const Inverse &inverse : ofSet) {
            farthest = std::max(farthest, sumOfSizes(inverse.turned.translation));
        }
    }
}

LocalFrames::Frame LocalFrames::child(const Frame &frame, SetId set, std::uint32_t map, const Box &box) const
{
    const Inverse &inverse = m_inverses[set][map];
    return {inverse.childFromParent(frame.p), frame.unit * inverse.scale, errorOf(frame, set, box)};
}

double LocalFrames::errorOf(const Frame &frame, SetId set, const Box &) const
{
    return frame.error + errorOfStep * (sumOfSizes(frame.p) + m_farthest[set]) * frame.unit;
}

double LocalFrames::distanceTo(const Frame &frame, const Box &box) const
{
    return distanceToBox(frame.p, box.least, box.greatest);
}

double LocalFrames::distanceTo(const Frame &frame, SetId set, std::uint32_t map, const Box &box) const
{
    const Inverse &inverse = m_inverses[set][map];
    return distanceToBox(inverse.turned(frame.p), box.least * inverse.scale, box.greatest * inverse.scale);
}

double LocalFrames::roughDistanceTo(const Frame &frame, SetId set, std::uint32_t map,
                                    const HullBounds::Hulls &hulls) const
{
    const Inverse &inverse = m_inverses[set][map];
    const glm::dvec3 way = inverse.turned(frame.p) - hulls.centre * inverse.scale;
    double reach = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3 &corner : hulls.coarse.corners) {
        reach = std::max(reach, glm::dot(way, corner));
    }
    const double length = glm::length(way);
    return length > 0.0 ? length - inverse.scale * (reach / length + hulls.coarse.error) : 0.0;
}

double LocalFrames::fineDistanceTo(const Frame &frame, SetId set, std::uint32_t map, const HullBounds::Hulls &hulls)
{
    const Inverse &inverse = m_inverses[set][map];
    const HullDistance distance = distanceToHull(hulls.fine.corners, inverse.childFromParent(frame.p));
    return inverse.scale * (distance.least - hulls.fine.error);
}

double LocalFrames::sizeOf(const Frame &, const Box &box) const
{
    return glm::length(box.size());
}

void LocalFrames::measure(const Frame &frame, double limit, LeafHit &hit)
{
    const FaceRanking &ranking = m_leaf.nearest(frame.p, limit);
    hit.face = ranking.face();
    hit.lower = ranking.lower();
    hit.faceTests = ranking.facesShown();
    if (hit.face != Mesh::none) {
        hit.triangle = triangleOf(m_mesh, hit.face);
        hit.nearest = closestPoint(hit.triangle, frame.p);
        hit.lower = std::min(hit.lower, hit.nearest.lower);
    }
}

void LocalFrames::finish(const Frame &frame, const LeafHit &leaf, std::span<const DescentStep> path, Hit &hit) const
{
    place(hit, leaf.nearest, leaf.triangle, frame.p);
    takeOut(frame, path, hit);
}

void LocalFrames::finish(const Frame &frame, const Box &box, std::span<const DescentStep> path, Hit &hit) const
{
    const glm::dvec3 middle = box.centre();
    const glm::dvec3 way = frame.p - middle;
    // a box that is small enough to be finished may be so far off that squares overflow
    place(hit, {middle, std::hypot(way.x, way.y, way.z), 0.0}, {middle, middle, middle}, frame.p);
    takeOut(frame, path, hit);
}

void LocalFrames::takeOut(const Frame &frame, std::span<const DescentStep> path, Hit &hit) const
{
    hit.distance *= frame.unit;
    for (const DescentStep &step : path | std::views::reverse) {
        const AffineMap &map = m_graph.set(step.set).maps[step.map];
        hit.point = map(hit.point);
        hit.direction = glm::normalize(map.linear * hit.direction / m_inverses[step.set][step.map].scale);
    }
}

}
