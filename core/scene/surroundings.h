// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "core/fractal/statetable.h"
#include "scene.h"

namespace romanesco {

/// What is seen from a place in a scene, in that place's own coordinates. Immutable; shared between threads.
struct Surroundings {
    /// A node of an item's graph, all below it included.
    struct Node {
        std::size_t item = 0;
        Positions state;
        AffineMap hereFromNode = {};
        /// So many steps of `path` lead there, and these after them.
        std::size_t sharedSteps = 0;
        boost::container::small_vector<Step, 1> steps = {};
        /// Only the base mesh in the node's frame, and nothing below it.
        bool isMeshOnly = false;
    };

    std::shared_ptr<const Scene> scene;
    /// Nodes of one item follow one another.
    std::vector<Node> nodes;
    /// From the root of an item to the node that the place belongs to; empty in the world.
    std::vector<Step> path;
    std::size_t pathItem = 0;
    /// Round that node, or the whole scene: the size of what is nearby.
    Sphere nearby;
    /// From its middle, how far everything reaches.
    double reach = 0.0;
    /// Where the place's origin stands in the world, as exactly as the world's coordinates can say, and the logarithm to
    /// base 2 of its unit.
    glm::dvec3 origin{0.0};
    double unitExponent = 0.0;

    /// To the coordinates of the place. What is too far away for a double stays in its direction.
    [[nodiscard]] glm::dvec3 hereFromWorld(const glm::dvec3 &inWorld) const;
    /// As exactly as the world's coordinates can say.
    [[nodiscard]] glm::dvec3 worldFromHere(const glm::dvec3 &here) const;

    /// Sets reach, from the nodes and what is nearby.
    void measureReach();
};

}
