// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "relativeframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "childhulls.h"
#include "core/geometry/sizes.h"
#include "core/geometry/triangledistance.h"
#include "nearest.h"

namespace romanesco {

namespace {

/// What a step may put a frame off by, of the numbers that are added: nine products and sums.
constexpr double errorOfStep = 8.0 * std::numeric_limits<double>::epsilon();

std::array<glm::dvec3, 3> halfEdges(const glm::dmat3 &linear, const Box &box)
{
    const glm::dvec3 half = 0.5 * box.size();
    return {linear[0] * half.x, linear[1] * half.y, linear[2] * half.z};
}

void put(Parallelepipeds &boxes, std::size_t lane, const glm::dvec3 &middle, const std::array<glm::dvec3, 3> &edges)
{
    setLane(boxes.middle, lane, middle);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        setLane(boxes.edges[i], lane, edges[i]);
    }
}

}

RelativeFrames::RelativeFrames(const FractalGraph &graph, const Mesh &mesh, const FaceTree &tree,
                               const LeafFaces &faces, const AffineMap &worldFromModel)
    : m_graph(graph)
    , m_mesh(mesh)
    , m_tree(tree)
    , m_faces(faces)
    , m_worldFromModel(worldFromModel)
    , m_norm(operatorNorm(worldFromModel.linear))
{
}

RelativeFrames::Frame RelativeFrames::begin(const Query &query, const Box &all)
{
    m_p = query.p;
    m_motion = query.motion;
    const AffineMap map{m_worldFromModel.linear, m_worldFromModel.translation - m_p};
    // as of a step with one map
    const double error = errorOfStep * (sumOfSizes(map.translation) + m_norm * sumOfSizes(all));
    return {.map = map, .norm = m_norm, .error = error};
}

RelativeFrames::Children RelativeFrames::boundsOf(std::span<const DescentStep> children, BoundedStates &states) const
{
    Children result;
    result.boxes.resize(blocksFor(children.size()));
    for (std::size_t i = 0; i < children.size(); ++i) {
        const DescentStep &step = children[i];
        const Box &box = (step.isToMesh() ? states.meshBounds() : states.bounds(step.state)).box;
        const AffineMap map = step.isToMesh() ? AffineMap{} : m_graph.set(step.set).maps[step.map];
        const double norm = step.isToMesh() ? 1.0 : m_graph.facts(step.set)[step.map].norm;
        put(result.boxes[i / laneCount], i % laneCount, map(box.centre()), halfEdges(map.linear, box));
        result.farthest = std::max(result.farthest, sumOfSizes(map.translation));
        result.reach = std::max(result.reach, norm * sumOfSizes(box));
    }
    result.hulls = hullsOf(children, states);
    return result;
}

RelativeFrames::Frame RelativeFrames::child(const Frame &frame, const DescentStep &step, double error) const
{
    return {frame.map * m_graph.set(step.set).maps[step.map], frame.norm * m_graph.facts(step.set)[step.map].norm,
            frame.depth + 1, error};
}

double RelativeFrames::errorOf(const Frame &frame, const Children &children) const
{
    return frame.error
        + errorOfStep
        * (sumOfSizes(frame.map.translation) + frame.norm * (children.farthest + (frame.depth + 1) * children.reach));
}

void RelativeFrames::distancesTo(const Frame &frame, const Children &children, double *distances) const
{
    romanesco::distancesTo(children.boxes, frame.map, distances);
}

void RelativeFrames::raiseToHulls(const Frame &frame, const Children &children, std::size_t block,
                                  double *distances) const
{
    romanesco::raiseToHulls(children.hulls[block], frame.map, frame.norm, distances);
}

double RelativeFrames::fineDistanceTo(const Frame &frame, const DescentStep &step, const BoundedStates::Bounds &bounds,
                                      double enough) const
{
    struct Placed final : PointsByDirection {
        const BoundedStates::Bounds &bounds;
        AffineMap map;

        Placed(const BoundedStates::Bounds &hull, const AffineMap &at)
            : bounds(hull)
            , map(at)
        {
        }
        [[nodiscard]] glm::dvec3 leastAlong(const glm::dvec3 &direction) const override
        {
            const std::size_t corner = romanesco::leastAlong(bounds.corners, glm::transpose(map.linear) * direction);
            return map(bounds.hulls->fine.corners[std::min(corner, bounds.hulls->fine.corners.size() - 1)]);
        }
    };
    const Placed placed(bounds, frame.map * m_graph.set(step.set).maps[step.map]);
    const double error = frame.norm * m_graph.facts(step.set)[step.map].norm * bounds.hulls->fine.error;
    const glm::dvec3 first = placed.leastAlong(placed.map(bounds.hulls->centre));
    return distanceToHull(first, placed, enough + error).least - error;
}

bool RelativeFrames::isBehind(const Frame &frame, const Box &box) const
{
    double ahead = glm::dot(frame.map(box.centre()), *m_motion);
    for (const glm::dvec3 &edge : halfEdges(frame.map.linear, box)) {
        ahead += std::abs(glm::dot(edge, *m_motion));
    }
    return ahead < -2.0 * frame.error * glm::length(*m_motion);
}

double RelativeFrames::apart(const Frame &one, const Frame &other, const Box &box)
{
    const glm::dvec3 farthest = glm::max(glm::abs(box.least), glm::abs(box.greatest));
    double apart = glm::distance(one.map.translation, other.map.translation);
    for (int axis = 0; axis < 3; ++axis) {
        apart += glm::distance(one.map.linear[axis], other.map.linear[axis]) * farthest[axis];
    }
    return apart;
}

double RelativeFrames::sizeOf(const Frame &frame, const BoundedStates::Bounds &bounds) const
{
    double size = 0.0;
    for (const glm::dvec3 &edge : halfEdges(frame.map.linear, bounds.box)) {
        size += 2.0 * glm::length(edge);
    }
    return size;
}

void RelativeFrames::measure(const Frame &frame, double limit, LeafHit &hit)
{
    if (!m_faces.isEmpty()) {
        m_faces.measure(frame.map, limit, m_motion, hit);
        return;
    }
    hit = {};
    const std::span<const FaceTree::Node> nodes = m_tree.nodes();
    m_waiting.clear();
    if (!nodes.empty()) {
        m_waiting.push_back({0.0, 0});
    }
    while (!m_waiting.empty()) {
        const Waiting waiting = m_waiting.back();
        m_waiting.pop_back();
        if (waiting.distance > limit) {
            hit.lower = std::min(hit.lower, waiting.distance);
            continue;
        }
        const FaceTree::Node &node = nodes[waiting.node];
        if (node.faceCount > 0) {
            measureFaces(frame, node, limit, hit);
            continue;
        }
        Parallelepipeds boxes;
        for (std::uint32_t i = 0; i < 2; ++i) {
            const Box &box = nodes[node.first + i].box;
            put(boxes, i, box.centre(), halfEdges(glm::dmat3(1.0), box));
        }
        Lanes distances;
        romanesco::distancesTo({&boxes, 1}, frame.map, distances.data());
        Waiting nearer{distances[0], node.first};
        Waiting farther{distances[1], node.first + 1};
        if (farther.distance < nearer.distance) {
            std::swap(nearer, farther);
        }
        m_waiting.push_back(farther);
        m_waiting.push_back(nearer);
    }
    if (hit.face != Mesh::none) {
        const ClosestPoint nearest = closestPoint(hit.triangle, glm::dvec3(0.0));
        hit.distance = nearest.distance;
        hit.lower = std::min(hit.lower, nearest.lower);
    }
}

void RelativeFrames::measureFaces(const Frame &frame, const FaceTree::Node &node, double &limit, LeafHit &hit) const
{
    for (const std::uint32_t face : m_tree.faces().subspan(node.first, node.faceCount)) {
        Triangle triangle = triangleOf(m_mesh, face);
        for (glm::dvec3 &vertex : triangle) {
            vertex = frame.map(vertex);
        }
        const TriangleDistance found = romanesco::distanceTo(triangle, glm::dvec3(0.0));
        ++hit.faceTests;
        const glm::dvec3 p(0.0);
        if (m_motion && !isAhead(closestPoint(triangle, p).point, triangle, p, m_motion)) {
            continue;
        }
        hit.lower = std::min(hit.lower, std::max(found.distance - found.error, 0.0));
        const bool isFirst = hit.face == Mesh::none;
        if (isFirst ? found.distance - found.error <= limit : found.distance < limit) {
            limit = found.distance;
            hit.face = face;
            hit.triangle = triangle;
        }
    }
}

void RelativeFrames::finish(const Frame &, const LeafHit &leaf, std::span<const DescentStep>, Hit &hit) const
{
    place(hit, closestPoint(leaf.triangle, glm::dvec3(0.0)), leaf.triangle, glm::dvec3(0.0), m_motion);
    hit.point += m_p;
}

void RelativeFrames::finish(const Frame &frame, const Box &box, std::span<const DescentStep>, Hit &hit) const
{
    const glm::dvec3 middle = frame.map(box.centre());
    place(hit, {middle, glm::length(middle), 0.0}, {middle, middle, middle}, glm::dvec3(0.0), m_motion);
    hit.point += m_p;
}

}
