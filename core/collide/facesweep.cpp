// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "facesweep.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "nearest.h"

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// What boxes and ways to them may be off by, of the largest coordinate there is: some roundings of each.
constexpr double errorOfBoxes = 32.0 * std::numeric_limits<double>::epsilon();

double largest(const Box &box)
{
    const glm::dvec3 reach = glm::max(glm::abs(box.least), glm::abs(box.greatest));
    return std::max({reach.x, reach.y, reach.z});
}

/// A mesh that stands still, seen from a point.
struct Standing {
    const glm::dvec3 &start;

    [[nodiscard]] BoxBody body(const Box &box) const { return {{box.least - start, box.greatest - start}}; }
    [[nodiscard]] static const Box &boxOf(const BoxBody &body) { return body.box; }
    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3 &vertex) const { return vertex - start; }
};

/// One that a map places.
struct Placed {
    const AffineMap &map;

    [[nodiscard]] ParallelepipedBody body(const Box &box) const { return parallelepiped(map, box); }
    [[nodiscard]] static Box boxOf(const ParallelepipedBody &body) { return body.box(); }
    [[nodiscard]] glm::dvec3 operator()(const glm::dvec3 &vertex) const { return map(vertex); }
};

template<typename View>
double wayToNode(const View &view, const Box &box, const MovingSphere &sphere, double until)
{
    const auto body = view.body(box);
    return wayTo(body, sphere, wayToBox(View::boxOf(body), sphere), until);
}

}

template<typename View>
void FaceSweep::search(const View &view, const MovingSphere &sphere, double limit, double slack, SweptFace &found)
{
    found = {};
    const std::span<const FaceTree::Node> nodes = m_tree.nodes();
    if (nodes.empty()) {
        return;
    }
    const double reach = largest(View::boxOf(view.body(nodes.front().box))) + sphere.radius;
    const MovingSphere grown{sphere.direction, sphere.radius + errorOfBoxes * reach};
    double until = limit;
    std::size_t waitingCount = 0;
    m_waiting[waitingCount++] = {wayToNode(view, nodes.front().box, grown, until), 0};
    while (waitingCount > 0) {
        const Waiting next = m_waiting[--waitingCount];
        if (next.way > until || next.way == infinity) {
            found.lower = std::min(found.lower, next.way);
            continue;
        }
        ++found.nodeVisits;
        const FaceTree::Node &node = nodes[next.node];
        if (node.faceCount == 0) {
            Waiting first{wayToNode(view, nodes[node.first].box, grown, until), node.first};
            Waiting second{wayToNode(view, nodes[node.first + 1].box, grown, until), node.first + 1};
            if (second.way < first.way) {
                std::swap(first, second);
            }
            m_waiting[waitingCount++] = second;
            m_waiting[waitingCount++] = first;
            continue;
        }
        for (const std::uint32_t face : m_tree.faces().subspan(node.first, node.faceCount)) {
            Triangle triangle = triangleOf(m_mesh, face);
            std::ranges::transform(triangle, triangle.begin(), view);
            ++found.faceTests;
            const TriangleTouch touched = touch(triangle, sphere, next.way, until);
            found.lower = std::min(found.lower, touched.way);
            if (touched.isTouch && (found.face == Mesh::none || touched.way < found.way)) {
                found.way = touched.way;
                found.face = face;
                found.triangle = triangle;
                until = earlierThan(touched.way, slack);
            }
        }
    }
}

double earlierThan(double way, double slack)
{
    return way > 0.0 ? way - slack : -1.0;
}

void FaceSweep::sweep(const glm::dvec3 &start, const MovingSphere &sphere, double limit, double slack, SweptFace &found)
{
    search(Standing{start}, sphere, limit, slack, found);
}

void FaceSweep::sweep(const AffineMap &map, const MovingSphere &sphere, double limit, double slack, SweptFace &found)
{
    search(Placed{map}, sphere, limit, slack, found);
}

}
