// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "treesearch.h"

#include <utility>

namespace romanesco {

const FaceRanking &TreeSearch::nearest(const glm::dvec3 &p, double radius, const std::optional<glm::dvec3> &motion)
{
    const std::span<const FaceTree::Node> nodes = m_tree.nodes();
    m_nodeVisits = 0;
    m_waitingCount = 0;
    m_ranking.begin(p, radius, nodes.empty() ? Box{p, p} : nodes.front().box, motion);
    if (!nodes.empty()) {
        m_waiting[m_waitingCount++] = {0, m_ranking.squareTo(nodes.front().box)};
    }
    while (m_waitingCount > 0) {
        const Waiting next = m_waiting[--m_waitingCount];
        if (!m_ranking.drops(next.square)) {
            visit(next.node);
        }
    }
    return m_ranking;
}

/// Down to a leaf, always into the nearer child.
void TreeSearch::visit(std::uint32_t index)
{
    while (true) {
        ++m_nodeVisits;
        const FaceTree::Node &node = m_tree.nodes()[index];
        if (node.faceCount > 0) {
            for (const std::uint32_t face : m_tree.faces().subspan(node.first, node.faceCount)) {
                m_ranking.show(face);
            }
            return;
        }
        Waiting nearer{node.first, m_ranking.squareTo(m_tree.nodes()[node.first].box)};
        Waiting farther{node.first + 1, m_ranking.squareTo(m_tree.nodes()[node.first + 1].box)};
        if (farther.square < nearer.square) {
            std::swap(nearer, farther);
        }
        if (m_ranking.drops(nearer.square)) {
            return;
        }
        if (!m_ranking.drops(farther.square)) {
            m_waiting[m_waitingCount++] = farther;
        }
        index = nearer.node;
    }
}

}
