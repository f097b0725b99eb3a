// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "octreecollider.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <format>
#include <limits>
#include <optional>
#include <span>
#include <utility>

#include <glm/common.hpp>

#include "core/fractal/copies.h"
#include "core/fractal/counts.h"
#include "nearest.h"
#include "sweeping.h"

namespace romanesco {

namespace {

constexpr std::uint64_t facesOfBox = 12;
constexpr double greatestCoordinate = 1e300;
constexpr double infinity = std::numeric_limits<double>::infinity();
using Result = std::expected<void, std::string>;

bool isHigh(unsigned octant, int axis)
{
    return (octant >> axis & 1u) != 0;
}

Box octantOf(const Box &box, unsigned octant)
{
    Box part = box;
    const glm::dvec3 centre = box.centre();
    for (int axis = 0; axis < 3; ++axis) {
        (isHigh(octant, axis) ? part.least : part.greatest)[axis] = centre[axis];
    }
    return part;
}

unsigned octantAt(const Box &box, const glm::dvec3 &point)
{
    const glm::dvec3 centre = box.centre();
    unsigned octant = 0;
    for (int axis = 0; axis < 3; ++axis) {
        octant |= point[axis] < centre[axis] ? 0u : 1u << axis;
    }
    return octant;
}

/// Puts points in order of their octants. Where each begins, and the end.
std::array<std::size_t, 9> sortByOctant(std::span<glm::dvec3> points, const Box &box)
{
    const glm::dvec3 centre = box.centre();
    std::array<std::size_t, 9> begins{};
    begins[8] = points.size();
    for (int axis = 2; axis >= 0; --axis) {
        const std::size_t step = std::size_t(1) << axis;
        for (std::size_t first = 0; first < 8; first += 2 * step) {
            const auto part = points.subspan(begins[first], begins[first + 2 * step] - begins[first]);
            const auto high =
                std::ranges::partition(part, [&](const glm::dvec3 &point) { return point[axis] < centre[axis]; });
            begins[first + step] = begins[first + 2 * step] - high.size();
        }
    }
    return begins;
}

/// The point of the walls nearest to p.
glm::dvec3 nearestOfWalls(const Box &box, const glm::dvec3 &p)
{
    glm::dvec3 point = glm::clamp(p, box.least, box.greatest);
    if (point != p) {
        return point;
    }
    double nearest = infinity;
    int across = 0;
    double place = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double wall : {box.least[axis], box.greatest[axis]}) {
            if (std::abs(p[axis] - wall) < nearest) {
                nearest = std::abs(p[axis] - wall);
                across = axis;
                place = wall;
            }
        }
    }
    point[across] = place;
    return point;
}

double distanceBetween(const glm::dvec3 &a, const glm::dvec3 &b)
{
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

double distanceToWalls(const Box &box, const glm::dvec3 &p)
{
    return distanceBetween(nearestOfWalls(box, p), p);
}

/// A half of a wall that a path touches, seen from its start.
struct WallTouch {
    double way = infinity;
    Triangle wall{};
};

WallTouch firstWall(const Box &box, const Path &path)
{
    WallTouch first;
    const glm::dvec3 least = box.least - path.start;
    const glm::dvec3 greatest = box.greatest - path.start;
    for (int axis = 0; axis < 3; ++axis) {
        for (unsigned i = 0; i < 4; ++i) {
            // a wall across the axis, cut from corner to corner
            glm::dvec3 between = i % 2 == 0 ? least : greatest;
            between[(axis + 1) % 3] = (i % 2 == 0 ? greatest : least)[(axis + 1) % 3];
            Triangle wall{least, between, greatest};
            for (glm::dvec3 &corner : wall) {
                corner[axis] = (i < 2 ? least : greatest)[axis];
            }
            const TriangleTouch found = touch(wall, path.sphere, 0.0, std::min(first.way, path.length));
            if (found.isTouch && found.way < first.way) {
                first = {found.way, wall};
            }
        }
    }
    return first;
}

}

class OctreeCollider::Builder
{
public:
    explicit Builder(OctreeCollider &tree)
        : m_tree(tree)
    {
    }

    Result takeVertices(const FractalGraph &graph, const Mesh &mesh, const std::stop_token &stop)
    {
        const std::vector<glm::dvec3> ofMesh = usedVertices(mesh);
        CopyWalk copies(graph, CopyWalk::Addresses::Drop, stop);
        while (copies.next()) {
            for (const glm::dvec3 &vertex : ofMesh) {
                const glm::dvec3 point = copies.modelFromBase()(vertex);
                for (int axis = 0; axis < 3; ++axis) {
                    if (!(std::abs(point[axis]) <= greatestCoordinate)) {
                        return std::unexpected(
                            std::format("a vertex is not finite, or too large (at most {})", greatestCoordinate));
                    }
                }
                m_points.push_back(point);
            }
        }
        return stop.stop_requested() ? Result(std::unexpect, "cancelled") : Result();
    }

    Result divide(const std::stop_token &stop)
    {
        m_tree.m_build.vertices = m_points.size();
        if (m_points.empty()) {
            return {};
        }
        m_tree.m_box = Box::ofNothing();
        for (const glm::dvec3 &point : m_points) {
            m_tree.m_box = m_tree.m_box.with(point);
        }
        m_tree.m_nodes.emplace_back();
        m_tasks.push_back({0, 0, m_tree.m_box, m_points});
        while (!m_tasks.empty()) {
            if (stop.stop_requested()) {
                return std::unexpected("cancelled");
            }
            const Task task = m_tasks.back();
            m_tasks.pop_back();
            finish(task);
        }
        m_tree.m_nodes.shrink_to_fit();
        m_tree.m_points.shrink_to_fit();
        m_tree.m_build.nodes = m_tree.m_nodes.size();
        return {};
    }

private:
    /// A node that is not divided yet.
    struct Task {
        std::uint32_t node;
        int depth;
        Box box;
        std::span<glm::dvec3> points;
    };

    void finish(const Task &task)
    {
        if (task.depth == m_tree.m_build.depth) {
            return;
        }
        if (std::ranges::all_of(task.points, [&](const glm::dvec3 &p) { return p == task.points.front(); })) {
            m_tree.m_nodes[task.node].first = static_cast<std::uint32_t>(m_tree.m_points.size());
            m_tree.m_points.push_back(task.points.front());
            return;
        }
        const auto begins = sortByOctant(task.points, task.box);
        m_tree.m_build.placements += task.points.size();
        m_tree.m_nodes[task.node].first = static_cast<std::uint32_t>(m_tree.m_nodes.size());
        for (unsigned octant = 0; octant < 8; ++octant) {
            const auto points = task.points.subspan(begins[octant], begins[octant + 1] - begins[octant]);
            if (!points.empty()) {
                m_tree.m_nodes[task.node].octants |= static_cast<std::uint8_t>(1u << octant);
                m_tasks.push_back({static_cast<std::uint32_t>(m_tree.m_nodes.size()), task.depth + 1,
                                   octantOf(task.box, octant), points});
                m_tree.m_nodes.emplace_back();
            }
        }
    }

    OctreeCollider &m_tree;
    std::vector<glm::dvec3> m_points;
    std::vector<Task> m_tasks;
};

class OctreeCollider::Descent final : public Search
{
public:
    explicit Descent(const OctreeCollider &tree)
        : m_tree(tree)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        clear(hit);
        hit.promise = Promise::None;
        hit.face = Mesh::none;
        if (m_tree.m_nodes.empty()) {
            return;
        }
        const auto rank = [&](const Box &box) { return Rank(0.0, distanceToWalls(box, query.p)); };
        const glm::dvec3 point = nearestOfWalls(lastBox(rank, hit.cost), query.p);
        const double distance = distanceBetween(point, query.p);
        const Triangle triangle{point, point, point};
        if (distance <= query.radius && isAhead(point, triangle, query.p, query.motion)) {
            place(hit, {point, distance, 0.0}, triangle, query.p, query.motion);
        }
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        clear(touch);
        touch.promise = Promise::None;
        touch.face = Mesh::none;
        if (m_tree.m_nodes.empty()) {
            return;
        }
        const Path path(sweep);
        const auto rank = [&](const Box &box) {
            const double way = firstWall(box, path).way;
            return Rank(way, way < infinity ? 0.0 : distanceToWalls(box, sweep.p));
        };
        const WallTouch found = firstWall(lastBox(rank, touch.cost), path);
        if (found.way < infinity) {
            place(touch, path, found.way, found.wall);
        }
    }

private:
    /// Of an octant; the least is gone on in.
    using Rank = std::pair<double, double>;

    template<typename RankOf>
    [[nodiscard]] Box lastBox(const RankOf &rankOf, SearchCost &cost) const
    {
        Box box = m_tree.m_box;
        std::uint32_t index = 0;
        for (int depth = 0; depth < m_tree.m_build.depth; ++depth) {
            ++cost.nodeVisits;
            const Node &node = m_tree.m_nodes[index];
            if (node.octants == 0) {
                box = octantOf(box, octantAt(box, m_tree.m_points[node.first]));
                cost.faceTests += facesOfBox;
            } else {
                const Choice choice = bestChild(node, box, rankOf);
                box = choice.box;
                index = choice.node;
                cost.faceTests += facesOfBox * static_cast<unsigned>(std::popcount(node.octants));
            }
        }
        return box;
    }

    struct Choice {
        std::uint32_t node;
        Box box;
    };
    template<typename RankOf>
    static Choice bestChild(const Node &node, const Box &box, const RankOf &rankOf)
    {
        Choice best{};
        Rank least(infinity, infinity);
        std::uint32_t child = node.first;
        for (unsigned octant = 0; octant < 8; ++octant) {
            if ((node.octants >> octant & 1u) != 0) {
                const Box part = octantOf(box, octant);
                if (const Rank rank = rankOf(part); rank < least) {
                    least = rank;
                    best = {child, part};
                }
                ++child;
            }
        }
        return best;
    }

    const OctreeCollider &m_tree;
};

int OctreeCollider::depthFor(std::uint64_t faces)
{
    // 3·log8 is log2
    return faces > 0 ? static_cast<int>(std::lround(std::log2(static_cast<double>(faces)))) : 0;
}

std::expected<OctreeCollider, std::string> OctreeCollider::create(const FractalGraph &graph, const Mesh &mesh,
                                                                  const std::stop_token &stop)
{
    const std::optional<Count> copies = instancesDistinct(graph);
    if (!copies) {
        return std::unexpected("the faces are too many to be counted");
    }
    const Count faces = *copies * Count(mesh.faces.size());
    const std::optional<std::uint64_t> count = faces.toInteger();
    if (!count || *count > mostFaces) {
        return std::unexpected(
            std::format("{} faces are too many for an octree (at most {})", faces.toString(), mostFaces));
    }
    OctreeCollider tree;
    tree.m_build.faces = *count;
    tree.m_build.depth = depthFor(*count);
    Builder builder(tree);
    const Result built = builder.takeVertices(graph, mesh, stop).and_then([&] { return builder.divide(stop); });
    if (!built) {
        return std::unexpected(built.error());
    }
    return tree;
}

std::unique_ptr<Search> OctreeCollider::search() const
{
    return std::make_unique<Descent>(*this);
}

std::size_t OctreeCollider::memoryUse() const
{
    return sizeof(*this) + m_nodes.capacity() * sizeof(Node) + m_points.capacity() * sizeof(glm::dvec3);
}

}
