// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "fractalgraph.h"

namespace romanesco {

/// Bounds of the least box round something.
struct BoxRange {
    /// Holds it.
    Box outer{glm::dvec3(-std::numeric_limits<double>::infinity()),
              glm::dvec3(std::numeric_limits<double>::infinity())};
    /// Reached by it on each side; of nothing where that is not known.
    Box reached = Box::ofNothing();
};

/// Bounds of h(u) = the greatest u·x of the points x of a set.
struct Support {
    double least = -std::numeric_limits<double>::infinity();
    double greatest = std::numeric_limits<double>::infinity();
};

/// Finds how far the nodes of a graph reach, by the recurrence h(u) = max over children of u·t + h(Aᵀu) of the child:
/// best first, so that only what reaches far is looked at. Maps of one set with the same linear part lead to the same
/// direction and count as one.
///
/// One thread uses it. The graph and the mesh must outlive it.
class SupportSearch
{
public:
    using Node = BoundLayout::Node;

    /// boxes: of each node, where they are known.
    SupportSearch(const FractalGraph &graph, const Mesh &mesh, std::span<const Box> boxes = {});
    ~SupportSearch();

    /// What is known of a node besides its sphere. To be set where more is found.
    [[nodiscard]] BoxRange &box(Node node) { return m_boxes[node]; }

    /// From the node's box and sphere alone.
    [[nodiscard]] Support known(Node node, const glm::dvec3 &direction) const;

    /// Looks at what the node leads to, and on from there until the bounds differ by at most the tolerance or the budget
    /// of maps and vertices is spent; the greatest is valid in any case, rounding included. What was looked at is taken
    /// off the budget.
    [[nodiscard]] Support search(Node node, const glm::dvec3 &direction, double tolerance, std::size_t &budget);

private:
    /// The maps of a set that have one linear part.
    struct Fan {
        glm::dmat3 linear;
        double norm;
        /// The greatest sum of a translation's coordinates.
        double translationSize;
        std::vector<glm::dvec3> translations;
    };
    struct Candidate;
    struct Open;
    class Search;

    const FractalGraph &m_graph;
    /// By set.
    std::vector<std::vector<Fan>> m_fans;
    /// By node: those of its steps that may be passed over, in order.
    std::vector<std::vector<SetId>> m_sets;
    /// Those that faces use.
    std::vector<glm::dvec3> m_vertices;
    std::vector<BoxRange> m_boxes;
    /// Of the search under way; kept for the room that they have.
    std::vector<Candidate> m_candidates;
    std::vector<Open> m_open;
};

}
