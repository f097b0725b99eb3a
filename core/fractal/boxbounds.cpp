// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "boxbounds.h"

#include <algorithm>
#include <cmath>

#include "boxgrowth.h"
#include "support.h"

namespace romanesco {

namespace {

using Node = BoundLayout::Node;

/// What a side may be too far out, of the largest side.
constexpr double tolerance = 1.0 / 256.0;
/// Maps looked at for all boxes together. Each side may take an equal part of what is left, or a little more while there
/// is much; the first look at what follows is free.
constexpr std::size_t wholeBudget = 1'000'000;
constexpr std::size_t looksPerNode = 12;
constexpr std::size_t littleMore = 500;

double largestSide(const Box &box)
{
    const glm::dvec3 size = box.size();
    return std::max({size.x, size.y, size.z});
}

}

class BoxBounds::Builder
{
public:
    Builder(const FractalGraph &graph, const Mesh &mesh)
        : m_graph(graph)
        , m_search(graph, mesh)
        , m_nodesLeft(graph.layout().nodeCount())
    {
    }

    std::vector<Box> build()
    {
        for (const BoundLayout::Stretch &stretch : m_graph.layout().stretches()) {
            for (Node node = stretch.firstOwn; node < stretch.firstOwn + stretch.ownCount; ++node) {
                lookOnce(node);
                refine(node);
            }
            if (stretch.sharedCount != 0) {
                findShared(stretch);
            } else if (stretch.begin + stretch.ownCount < stretch.end) {
                const Box after = m_search.box(stretch.exit).outer;
                m_search.box(stretch.entry).outer = grownBox(m_graph, stretch.begin, stretch.end, after);
            }
        }
        std::vector<Box> boxes;
        boxes.reserve(m_graph.layout().nodeCount());
        for (Node node = 0; node < m_graph.layout().nodeCount(); ++node) {
            boxes.push_back(m_search.box(node).outer);
        }
        return boxes;
    }

private:
    /// One side, within what was known.
    void look(Node node, int axis, bool isUp, double sideTolerance)
    {
        glm::dvec3 direction(0.0);
        direction[axis] = isUp ? 1.0 : -1.0;
        const std::size_t whole =
            std::max(m_budget / (looksPerNode * m_nodesLeft), std::min(m_budget / 16, littleMore));
        std::size_t budget = whole;
        const Support support = m_search.search(node, direction, sideTolerance, budget);
        m_budget -= std::min(m_budget, whole - budget);
        auto &[outer, reached] = m_search.box(node);
        if (isUp) {
            outer.greatest[axis] = std::min(outer.greatest[axis], support.greatest);
            reached.greatest[axis] = std::max(reached.greatest[axis], support.least);
        } else {
            outer.least[axis] = std::max(outer.least[axis], -support.greatest);
            reached.least[axis] = std::min(reached.least[axis], -support.least);
        }
    }

    /// All sides, from the boxes of what follows at once.
    void lookOnce(Node node)
    {
        for (int axis = 0; axis < 3; ++axis) {
            look(node, axis, true, infinite);
            look(node, axis, false, infinite);
        }
    }

    /// The sides that may be too far out.
    void refine(Node node)
    {
        const BoxRange found = m_search.box(node);
        const double most = tolerance * largestSide(found.outer);
        for (int axis = 0; axis < 3; ++axis) {
            if (found.outer.greatest[axis] - found.reached.greatest[axis] > most) {
                look(node, axis, true, most);
            }
            if (found.reached.least[axis] - found.outer.least[axis] > most) {
                look(node, axis, false, most);
            }
        }
        --m_nodesLeft;
    }

    /// From the spheres, which are good at every depth, inwards: each round what follows is better known.
    void findShared(const BoundLayout::Stretch &stretch)
    {
        constexpr int mostRounds = 40;
        const Node end = stretch.firstShared + stretch.sharedCount;
        bool isMoving = true;
        for (int round = 0; round < mostRounds && isMoving; ++round) {
            isMoving = false;
            for (Node node = stretch.firstShared; node < end; ++node) {
                const Box before = m_search.box(node).outer;
                lookOnce(node);
                const Box &after = m_search.box(node).outer;
                const double most = tolerance / 256.0 * largestSide(after);
                isMoving = isMoving || !(largestSide(before) - largestSide(after) <= most);
            }
        }
        for (Node node = stretch.firstShared; node < end; ++node) {
            refine(node);
        }
    }

    static constexpr double infinite = std::numeric_limits<double>::infinity();

    const FractalGraph &m_graph;
    SupportSearch m_search;
    std::size_t m_nodesLeft;
    std::size_t m_budget = wholeBudget;
};

BoxBounds::BoxBounds(const FractalGraph &graph, const Mesh &mesh)
    : m_boxes(Builder(graph, mesh).build())
{
}

Box BoxBounds::at(const FractalGraph &graph, Position position) const
{
    if (const std::optional<Node> node = graph.layout().nodeAt(graph.levels(), position)) {
        return m_boxes[*node];
    }
    const BoundLayout::Stretch &stretch = graph.layout().stretchAt(position);
    return grownBox(graph, position, stretch.end, m_boxes[stretch.exit]);
}

}
