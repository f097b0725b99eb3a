// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "hullbounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

using Node = BoundLayout::Node;

constexpr std::size_t mostNodes = 512;
constexpr std::size_t mostCorners = 96;
/// What corners may leave outside, of the box's diagonal.
constexpr double tolerance = 1e-12;
/// A hull that comes so near to all corners of its box is no better than that.
constexpr double likeBox = 0.02;

std::vector<glm::dvec3> cornersOf(const Box &box)
{
    std::vector<glm::dvec3> corners;
    corners.reserve(8);
    for (int i = 0; i < 8; ++i) {
        corners.emplace_back(i & 1 ? box.greatest.x : box.least.x, i & 2 ? box.greatest.y : box.least.y,
                             i & 4 ? box.greatest.z : box.least.z);
    }
    return corners;
}

}

class HullBounds::Builder
{
public:
    Builder(const FractalGraph &graph, const BoxBounds &boxes, const std::stop_token &stop)
        : m_graph(graph)
        , m_boxes(boxes.ofNodes())
        , m_stop(stop)
        , m_hulls(graph.layout().nodeCount())
    {
    }

    std::vector<Hulls> build(const Mesh &mesh)
    {
        m_hulls[BoundLayout::end] = chosenOf(BoundLayout::end, usedVertices(mesh));
        for (const BoundLayout::Stretch &stretch : m_graph.layout().stretches()) {
            for (Node node = stretch.firstOwn; node < stretch.firstOwn + stretch.ownCount; ++node) {
                if (m_stop.stop_requested()) {
                    return {};
                }
                m_hulls[node] = chosenOf(node, contentOf(node));
                m_hulls[node].error += outsideOf(node) + rounding(node);
            }
            findShared(stretch);
            if (stretch.entry >= m_hulls.size() || m_hulls[stretch.entry].isEmpty()) {
                useBox(stretch.entry);
            }
        }
        if (m_stop.stop_requested()) {
            return {};
        }
        std::vector<Hulls> all(m_hulls.size());
        for (Node node = 0; node < m_hulls.size(); ++node) {
            if (!isLikeBox(node)) {
                all[node] = withCoarse(std::move(m_hulls[node]));
            }
        }
        return all;
    }

private:
    static Hulls withCoarse(Hull &&fine)
    {
        Hulls hulls{.fine = std::move(fine), .coarse = {}};
        hulls.coarse = thinned(hulls.fine.corners, mostCoarseCorners, 0.0);
        hulls.coarse.error += hulls.fine.error;
        for (const glm::dvec3 &corner : hulls.coarse.corners) {
            hulls.centre += corner / static_cast<double>(hulls.coarse.corners.size());
        }
        for (glm::dvec3 &corner : hulls.coarse.corners) {
            corner -= hulls.centre;
        }
        return hulls;
    }

    [[nodiscard]] double sizeOf(Node node) const { return glm::length(m_boxes[node].size()); }

    /// How far off a corner may be that is brought into the node's frame.
    [[nodiscard]] double rounding(Node node) const
    {
        return 16.0 * std::numeric_limits<double>::epsilon() * (sizeOf(node) + glm::length(m_boxes[node].centre()));
    }

    [[nodiscard]] Hull chosenOf(Node node, std::span<const glm::dvec3> points) const
    {
        return thinned(points, mostCorners, tolerance * sizeOf(node));
    }

    /// Where the corners of what follows a node are in its frame.
    [[nodiscard]] std::vector<glm::dvec3> contentOf(Node node) const
    {
        std::vector<glm::dvec3> points;
        forEachPart(node, [&](const AffineMap &map, double, const Hull &hull) {
            for (const glm::dvec3 &corner : hull.corners) {
                points.push_back(map(corner));
            }
        });
        return points;
    }

    /// How far what follows a node may be outside the hulls of it.
    [[nodiscard]] double outsideOf(Node node) const
    {
        double outside = 0.0;
        forEachPart(node, [&](const AffineMap &, double norm, const Hull &hull) {
            outside = std::max(outside, norm * hull.error);
        });
        return outside;
    }

    /// Each copy of what follows: take(map, norm, hull).
    void forEachPart(Node node, const auto &take) const
    {
        for (const auto &[slot, next] : m_graph.layout().steps(node)) {
            const TransformSet &set = m_graph.setAt(slot);
            const std::vector<MapFacts> &facts = m_graph.facts(m_graph.levels().set(slot));
            for (std::size_t i = 0; i < set.maps.size(); ++i) {
                take(set.maps[i], facts[i].norm, m_hulls[next]);
            }
            if (set.holdsIdentity && next != node) {
                take(AffineMap{}, 1.0, m_hulls[next]);
            }
        }
    }

    // ---- What positions share

    /// Corners by following the levels round until little is added; then errors that hold what follows.
    void findShared(const BoundLayout::Stretch &stretch)
    {
        constexpr int mostRounds = 60;
        const Node first = stretch.firstShared;
        const Node end = first + stretch.sharedCount;
        if (first == end) {
            return;
        }
        for (Node node = first; node < end; ++node) {
            m_hulls[node].corners = m_hulls[first - 1].corners;
        }
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            double moved = 0.0;
            for (Node node = first; node < end; ++node) {
                Hull hull = chosenOf(node, contentOf(node));
                for (const glm::dvec3 &corner : hull.corners) {
                    moved = std::max(moved, distanceToHull(m_hulls[node].corners, corner).greatest / sizeOf(node));
                }
                m_hulls[node] = std::move(hull);
            }
            if (!(moved > tolerance)) {
                break;
            }
        }
        if (!settle(first, end)) {
            for (Node node = first; node < end; ++node) {
                useBox(node);
            }
        }
    }

    /// Errors grow until each hull holds what follows it, with its error.
    bool settle(Node first, Node end)
    {
        constexpr int mostRounds = 2'000;
        std::vector<std::vector<double>> outside(end - first);
        for (Node node = first; node < end; ++node) {
            m_hulls[node].error = 0.0;
            forEachPart(node, [&](const AffineMap &map, double, const Hull &hull) {
                double &farthest = outside[node - first].emplace_back(rounding(node));
                for (const glm::dvec3 &corner : hull.corners) {
                    farthest = std::max(farthest, distanceToHull(m_hulls[node].corners, map(corner)).greatest);
                }
            });
        }
        for (int round = 0; round < mostRounds && !m_stop.stop_requested(); ++round) {
            bool isSettled = true;
            for (Node node = first; node < end; ++node) {
                double needed = 0.0;
                std::size_t part = 0;
                forEachPart(node, [&](const AffineMap &, double norm, const Hull &hull) {
                    needed = std::max(needed, outside[node - first][part++] + norm * hull.error);
                });
                if (!(needed <= m_hulls[node].error)) {
                    m_hulls[node].error = needed * (1.0 + 1e-6);
                    isSettled = false;
                }
            }
            if (isSettled) {
                return true;
            }
        }
        return false;
    }

    // ---- Boxes

    void useBox(Node node) { m_hulls[node] = {cornersOf(m_boxes[node]), 0.0}; }

    [[nodiscard]] bool isLikeBox(Node node) const
    {
        const double most = likeBox * sizeOf(node);
        return m_hulls[node].isEmpty() || !(m_hulls[node].error <= most)
            || std::ranges::all_of(cornersOf(m_boxes[node]), [&](const glm::dvec3 &corner) {
                   return distanceToHull(m_hulls[node].corners, corner).greatest <= most;
               });
    }

    const FractalGraph &m_graph;
    std::span<const Box> m_boxes;
    const std::stop_token &m_stop;
    std::vector<Hull> m_hulls;
};

HullBounds::HullBounds(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, const std::stop_token &stop)
{
    const bool isSmall = graph.layout().nodeCount() <= mostNodes;
    const bool isFinite = std::ranges::all_of(boxes.ofNodes(), [](const Box &box) {
        return !box.isEmpty() && glm::length(box.size()) < 1e100 && glm::length(box.centre()) < 1e100;
    });
    if (isSmall && isFinite) {
        m_hulls = Builder(graph, boxes, stop).build(mesh);
    }
}

const HullBounds::Hulls *HullBounds::at(const FractalGraph &graph, Position position) const
{
    const auto node = m_hulls.empty() ? std::nullopt : graph.layout().nodeAt(graph.levels(), position);
    return node && !m_hulls[*node].fine.isEmpty() ? &m_hulls[*node] : nullptr;
}

std::size_t HullBounds::memoryUse() const
{
    std::size_t bytes = m_hulls.capacity() * sizeof(Hulls);
    for (const Hulls &hulls : m_hulls) {
        bytes += (hulls.fine.corners.capacity() + hulls.coarse.corners.capacity()) * sizeof(glm::dvec3);
    }
    return bytes;
}

}
