// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <stop_token>
#include <vector>

#include "boxbounds.h"
#include "core/geometry/hull.h"
#include "fractalgraph.h"

namespace romanesco {

/// Convex hulls of what the levels from a position on make of a mesh, in the frame at that position, with few corners:
/// what is under a position lies within the hull's error of it. Where a box is a poor bound, a collider meets many boxes
/// that are nearly as near as what it looks for, and ever more the deeper it goes; hulls touch what they bound.
///
/// Kept by the nodes of the graph's BoundLayout, from the end upwards: corners are chosen from those of what follows.
/// Where positions share a node, its error is such that the hull holds all that may follow, at any depth. There is none
/// where the box is as good, where a stretch grows, and where there are more than some hundred nodes.
class HullBounds
{
public:
    struct Hulls {
        /// At most 96 corners.
        Hull fine;
        /// At most 16 of them, seen from a point between them.
        Hull coarse;
        glm::dvec3 centre{0.0};
    };
    static constexpr std::size_t mostCoarseCorners = 16;

    HullBounds() = default;

    /// Cost: some milliseconds a node. Once a stop is requested there are none.
    HullBounds(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &mesh, const std::stop_token &stop = {});

    /// Null where there is none.
    [[nodiscard]] const Hulls *at(const FractalGraph &graph, Position position) const;

    [[nodiscard]] std::size_t memoryUse() const;

private:
    class Builder;

    /// By node; empty where there is none.
    std::vector<Hulls> m_hulls;
};

}
