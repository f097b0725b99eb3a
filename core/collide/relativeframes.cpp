// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "relativeframes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ranges>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/triangledistance.h"
#include "nearest.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// What a step may put a frame off by, of the numbers that are added: nine products and sums.
constexpr double errorOfStep = 8.0 * std::numeric_limits<double>::epsilon();

double sumOfSizes(const glm::dvec3 &v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

double reachOf(const Box &box)
{
    return sumOfSizes(glm::max(glm::abs(box.least), glm::abs(box.greatest)));
}

/// From the origin to the parallelepiped of a middle and half edges, never more than it is but for rounding: for any
/// direction x no point of it is nearer than (x·middle − Σ|x·edge|)/|x|. x is the nearest point, nearly: from the middle
/// two rounds along the edges.
double distanceToOrigin(const glm::dvec3 &middle, const std::array<glm::dvec3, 3> &edges)
{
    glm::dvec3 nearest = middle;
    std::array<double, 3> along{};
    for (int round = 0; round < 2; ++round) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double square = glm::dot(edges[i], edges[i]);
            if (square > 0.0) {
                const double next = std::clamp(along[i] - glm::dot(nearest, edges[i]) / square, -1.0, 1.0);
                nearest += (next - along[i]) * edges[i];
                along[i] = next;
            }
        }
    }
    const double length = glm::length(nearest);
    double reach = glm::dot(nearest, middle);
    for (const glm::dvec3 &edge : edges) {
        reach -= std::abs(glm::dot(nearest, edge));
    }
    return length > 0.0 && reach > 0.0 ? reach / length : 0.0;
}

std::array<glm::dvec3, 3> halfEdges(const glm::dmat3 &linear, const Box &box)
{
    const glm::dvec3 half = 0.5 * box.size();
    return {linear[0] * half.x, linear[1] * half.y, linear[2] * half.z};
}

}

RelativeFrames::RelativeFrames(const FractalGraph &graph, const Mesh &mesh, const FaceTree &tree,
                               const AffineMap &worldFromModel)
    : m_graph(graph)
    , m_mesh(mesh)
    , m_tree(tree)
    , m_worldFromModel(worldFromModel)
    , m_norm(operatorNorm(worldFromModel.linear))
{
    for (SetId set = 0; set < graph.setCount(); ++set) {
        Growth &growth = m_growth.emplace_back();
        for (const auto &[map, facts] : std::views::zip(graph.set(set).maps, graph.facts(set))) {
            growth.farthest = std::max(growth.farthest, sumOfSizes(map.translation));
            growth.norm = std::max(growth.norm, facts.norm);
        }
    }
}

RelativeFrames::Frame RelativeFrames::begin(const glm::dvec3 &p)
{
    m_p = p;
    const AffineMap map{m_worldFromModel.linear, m_worldFromModel.translation - p};
    // as of a step with one map, to the mesh
    const double error = m_tree.nodes().empty()
        ? 0.0
        : errorOfStep * (sumOfSizes(map.translation) + m_norm * reachOf(m_tree.nodes().front().box));
    return {.map = map, .norm = m_norm, .error = error};
}

RelativeFrames::Frame RelativeFrames::child(const Frame &frame, SetId set, std::uint32_t map, const Box &box) const
{
    return {frame.map * m_graph.set(set).maps[map], frame.norm * m_graph.facts(set)[map].norm, frame.depth + 1,
            errorOf(frame, set, box)};
}

double RelativeFrames::errorOf(const Frame &frame, SetId set, const Box &box) const
{
    const auto [farthest, norm] = m_growth[set];
    return frame.error
        + errorOfStep
        * (sumOfSizes(frame.map.translation) + frame.norm * (farthest + (frame.depth + 1) * norm * reachOf(box)));
}

double RelativeFrames::distanceTo(const Frame &frame, const Box &box) const
{
    return distanceToOrigin(frame.map(box.centre()), halfEdges(frame.map.linear, box));
}

double RelativeFrames::distanceTo(const Frame &frame, SetId set, std::uint32_t map, const Box &box) const
{
    const AffineMap &inner = m_graph.set(set).maps[map];
    std::array<glm::dvec3, 3> edges = halfEdges(inner.linear, box);
    for (glm::dvec3 &edge : edges) {
        edge = frame.map.linear * edge;
    }
    return distanceToOrigin(frame.map(inner(box.centre())), edges);
}

double RelativeFrames::roughDistanceTo(const Frame &frame, SetId set, std::uint32_t map,
                                       const HullBounds::Hulls &hulls) const
{
    const AffineMap &inner = m_graph.set(set).maps[map];
    const glm::dvec3 way = frame.map(inner(hulls.centre));
    const glm::dvec3 inChild = glm::transpose(inner.linear) * (glm::transpose(frame.map.linear) * way);
    double nearest = infinity;
    for (const glm::dvec3 &corner : hulls.coarse.corners) {
        nearest = std::min(nearest, glm::dot(inChild, corner));
    }
    const double length = glm::length(way);
    const double error = frame.norm * m_graph.facts(set)[map].norm * hulls.coarse.error;
    return length > 0.0 ? length + nearest / length - error : 0.0;
}

double RelativeFrames::fineDistanceTo(const Frame &frame, SetId set, std::uint32_t map, const HullBounds::Hulls &hulls)
{
    const AffineMap &inner = m_graph.set(set).maps[map];
    m_corners.clear();
    for (const glm::dvec3 &corner : hulls.fine.corners) {
        m_corners.push_back(frame.map(inner(corner)));
    }
    return distanceToHull(m_corners, glm::dvec3(0.0)).least
        - frame.norm * m_graph.facts(set)[map].norm * hulls.fine.error;
}

double RelativeFrames::sizeOf(const Frame &frame, const Box &box) const
{
    double size = 0.0;
    for (const glm::dvec3 &edge : halfEdges(frame.map.linear, box)) {
        size += 2.0 * glm::length(edge);
    }
    return size;
}

void RelativeFrames::measure(const Frame &frame, double limit, LeafHit &hit)
{
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
        Waiting nearer{distanceTo(frame, nodes[node.first].box), node.first};
        Waiting farther{distanceTo(frame, nodes[node.first + 1].box), node.first + 1};
        if (farther.distance < nearer.distance) {
            std::swap(nearer, farther);
        }
        m_waiting.push_back(farther);
        m_waiting.push_back(nearer);
    }
    if (hit.face != Mesh::none) {
        hit.nearest = closestPoint(hit.triangle, glm::dvec3(0.0));
        hit.lower = std::min(hit.lower, hit.nearest.lower);
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
    place(hit, leaf.nearest, leaf.triangle, glm::dvec3(0.0));
    hit.point += m_p;
}

void RelativeFrames::finish(const Frame &frame, const Box &box, std::span<const DescentStep>, Hit &hit) const
{
    const glm::dvec3 middle = frame.map(box.centre());
    place(hit, {middle, glm::length(middle), 0.0}, {middle, middle, middle}, glm::dvec3(0.0));
    hit.point += m_p;
}

}
