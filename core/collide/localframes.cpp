// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "localframes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ranges>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "childhulls.h"
#include "core/geometry/similarity.h"
#include "core/geometry/sizes.h"
#include "nearest.h"

namespace romanesco {

namespace {

/// What a step may put p off by, of the numbers that are added: nine products and sums, with factors that are rounded.
constexpr double errorOfStep = 8.0 * std::numeric_limits<double>::epsilon();

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

LocalFrames::LocalFrames(const FractalGraph &graph, const Inverses &inverses, const Mesh &mesh, const FaceTree &tree,
                         const LeafFaces &faces)
    : m_graph(graph)
    , m_inverses(inverses)
    , m_mesh(mesh)
    , m_leaf(mesh, tree)
    , m_faces(faces)
{
}

LocalFrames::Children LocalFrames::boundsOf(std::span<const DescentStep> children, BoundedStates &states) const
{
    Children result;
    result.boxes.resize(blocksFor(children.size()));
    for (std::size_t i = 0; i < children.size(); ++i) {
        const DescentStep &step = children[i];
        const Inverse inverse = step.isToMesh() ? Inverse{} : m_inverses[step.set][step.map];
        const Box &box = (step.isToMesh() ? states.meshBounds() : states.bounds(step.state)).box;
        const glm::dvec3 middle = box.centre() * inverse.scale;
        // of a box that is rounded no part is left out
        const glm::dvec3 half = glm::max(box.greatest * inverse.scale - middle, middle - box.least * inverse.scale);
        TurnedBoxes &boxes = result.boxes[i / laneCount];
        const std::size_t lane = i % laneCount;
        for (int row = 0; row < 3; ++row) {
            setLane(boxes.turned[static_cast<std::size_t>(row)], lane, glm::row(inverse.turned.linear, row));
        }
        setLane(boxes.offset, lane, inverse.turned.translation - middle);
        setLane(boxes.half, lane, half);
        result.reach =
            std::max(result.reach, sumOfSizes(inverse.turned.translation) + sumOfSizes(middle) + sumOfSizes(half));
    }
    result.hulls = hullsOf(children, states);
    return result;
}

LocalFrames::Frame LocalFrames::child(const Frame &frame, const DescentStep &step, double error) const
{
    const Inverse &inverse = m_inverses[step.set][step.map];
    Frame child{inverse.childFromParent(frame.p), frame.unit * inverse.scale, error};
    if (frame.motion) {
        child.motion = inverse.turned.linear * *frame.motion;
    }
    return child;
}

double LocalFrames::errorOf(const Frame &frame, const Children &children) const
{
    return frame.error + errorOfStep * (sumOfSizes(frame.p) + children.reach) * frame.unit;
}

void LocalFrames::distancesTo(const Frame &frame, const Children &children, double *distances) const
{
    romanesco::distancesTo(children.boxes, frame.p, distances);
}

void LocalFrames::raiseToHulls(const Frame &frame, const Children &children, std::size_t block, double *distances) const
{
    romanesco::raiseToHulls(children.hulls[block], frame.p, distances);
}

double LocalFrames::fineDistanceTo(const Frame &frame, const DescentStep &step, const BoundedStates::Bounds &bounds,
                                   double enough) const
{
    struct Seen final : PointsByDirection {
        const BoundedStates::Bounds &bounds;
        glm::dvec3 p;

        Seen(const BoundedStates::Bounds &hull, const glm::dvec3 &from)
            : bounds(hull)
            , p(from)
        {
        }
        [[nodiscard]] glm::dvec3 leastAlong(const glm::dvec3 &direction) const override
        {
            const std::size_t corner = romanesco::leastAlong(bounds.corners, direction);
            return bounds.hulls->fine.corners[std::min(corner, bounds.hulls->fine.corners.size() - 1)] - p;
        }
    };
    const Inverse &inverse = m_inverses[step.set][step.map];
    const Seen seen(bounds, inverse.childFromParent(frame.p));
    const double error = bounds.hulls->fine.error;
    const glm::dvec3 first = seen.leastAlong(bounds.hulls->centre - seen.p);
    return inverse.scale * (distanceToHull(first, seen, enough / inverse.scale + error).least - error);
}

bool LocalFrames::isBehind(const Frame &frame, const Box &box) const
{
    const glm::dvec3 &motion = *frame.motion;
    const glm::dvec3 ahead = glm::max((box.least - frame.p) * motion, (box.greatest - frame.p) * motion);
    return ahead.x + ahead.y + ahead.z < -2.0 * frame.error / frame.unit * glm::length(motion);
}

double LocalFrames::apart(const Frame &one, const Frame &other, const Box &box)
{
    if (one.motion != other.motion) {
        return std::numeric_limits<double>::infinity();
    }
    const double farthest = sumOfSizes(one.p) + sumOfSizes(box);
    return glm::distance(one.p, other.p) * other.unit + farthest * std::abs(one.unit - other.unit);
}

double LocalFrames::sizeOf(const Frame &, const BoundedStates::Bounds &bounds) const
{
    return bounds.size;
}

void LocalFrames::measure(const Frame &frame, double limit, LeafHit &hit)
{
    if (!m_faces.isEmpty()) {
        m_faces.measure(frame.p, limit, frame.motion, hit);
        return;
    }
    const FaceRanking &ranking = m_leaf.nearest(frame.p, limit, frame.motion);
    hit.face = ranking.face();
    hit.lower = ranking.lower();
    hit.faceTests = ranking.facesShown();
    if (hit.face != Mesh::none) {
        hit.triangle = triangleOf(m_mesh, hit.face);
        const ClosestPoint nearest = closestPoint(hit.triangle, frame.p);
        hit.distance = nearest.distance;
        hit.lower = std::min(hit.lower, nearest.lower);
    }
}

void LocalFrames::finish(const Frame &frame, const LeafHit &leaf, std::span<const DescentStep> path, Hit &hit) const
{
    place(hit, closestPoint(leaf.triangle, frame.p), leaf.triangle, frame.p, frame.motion);
    takeOut(frame, path, hit);
}

void LocalFrames::finish(const Frame &frame, const Box &box, std::span<const DescentStep> path, Hit &hit) const
{
    const glm::dvec3 middle = box.centre();
    const glm::dvec3 way = frame.p - middle;
    // a box that is small enough to be finished may be so far off that squares overflow
    place(hit, {middle, std::hypot(way.x, way.y, way.z), 0.0}, {middle, middle, middle}, frame.p, frame.motion);
    takeOut(frame, path, hit);
}

void LocalFrames::takeOut(const Frame &frame, std::span<const DescentStep> path, Hit &hit) const
{
    hit.distance *= frame.unit;
    for (const DescentStep &step : path | std::views::reverse) {
        const AffineMap &map = m_graph.set(step.set).maps[step.map];
        hit.point = map(hit.point);
        hit.direction = map.linear * hit.direction / m_inverses[step.set][step.map].scale;
    }
    hit.direction = glm::normalize(hit.direction);
}

}
