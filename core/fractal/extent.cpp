// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "extent.h"

#include "support.h"

namespace romanesco {

namespace {

double greatestReach(SupportSearch &search, const FractalGraph &graph, const glm::dvec3 &direction, std::size_t budget)
{
    return search.search(graph.layout().entry(), direction, 0.0, budget).greatest;
}

}

double reachAlong(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &base, const glm::dvec3 &direction,
                  std::size_t budget)
{
    SupportSearch search(graph, base, boxes.ofNodes());
    return greatestReach(search, graph, direction, budget);
}

Box extent(const FractalGraph &graph, const BoxBounds &boxes, const Mesh &base, std::size_t budget)
{
    if (graph.base().isEmpty()) {
        return {};
    }
    SupportSearch search(graph, base, boxes.ofNodes());
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 direction(0.0);
        direction[axis] = 1.0;
        box.greatest[axis] = greatestReach(search, graph, direction, budget);
        box.least[axis] = -greatestReach(search, graph, -direction, budget);
    }
    return box;
}

}
