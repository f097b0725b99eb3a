// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "surroundings.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Where to keep the direction of what lies farther away.
constexpr double farthest = 1e100;

/// From the middle of what is nearby.
double reachOf(const Surroundings &all, const Surroundings::Node &node)
{
    const Sphere &bound = all.scene->items[node.item].model->graph.bound(node.state.front());
    if (bound.isEmpty()) {
        return 0.0;
    }
    const Sphere here = transformed(node.hereFromNode, operatorNorm(node.hereFromNode.linear), bound);
    return glm::distance(here.centre, all.nearby.centre) + here.radius;
}

}

glm::dvec3 Surroundings::hereFromWorld(const glm::dvec3 &inWorld) const
{
    const glm::dvec3 away = inWorld - origin;
    const double length = glm::length(away);
    if (!(length > 0.0)) {
        return glm::dvec3(0.0);
    }
    const double exponent = std::log2(length) - unitExponent;
    return away / length * std::min(std::exp2(std::min(exponent, 1000.0)), farthest);
}

void Surroundings::measureReach()
{
    reach = nearby.radius;
    for (const Node &node : nodes) {
        reach = std::max(reach, reachOf(*this, node));
    }
}

glm::dvec3 Surroundings::worldFromHere(const glm::dvec3 &here) const
{
    return origin + std::exp2(unitExponent) * here;
}

}
