// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>

#include "faceranking.h"
#include "facetree.h"

namespace romanesco {

/// Goes down a tree of a mesh's faces, nearer boxes first, past those that cannot hold the nearest face. It never
/// allocates. One thread uses it.
class TreeSearch
{
public:
    /// Both must outlive it; the tree is of that mesh.
    TreeSearch(const Mesh &mesh, const FaceTree &tree)
        : m_tree(tree)
        , m_ranking(mesh)
    {
    }

    /// Ranks the faces within radius of p, whose coordinates are at most 1e300; those ahead, where p moves. The answer is valid until the next call,
    /// and the same for every tree of the mesh, but for what it cost and how low `lower()` is.
    const FaceRanking &nearest(const glm::dvec3 &p, double radius, const std::optional<glm::dvec3> &motion);

    /// Nodes whose children were looked at, and leaves, by the last call.
    [[nodiscard]] std::uint64_t nodeVisits() const { return m_nodeVisits; }

private:
    /// A node that is to be visited unless its box, at that squared distance, is dropped until then.
    struct Waiting {
        std::uint32_t node;
        double square;
    };

    void visit(std::uint32_t node);

    const FaceTree &m_tree;
    FaceRanking m_ranking;
    std::array<Waiting, FaceTree::mostDepth> m_waiting;
    std::size_t m_waitingCount = 0;
    std::uint64_t m_nodeVisits = 0;
};

}
