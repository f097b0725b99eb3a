// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/nametable.h"
#include "levelsequence.h"

namespace romanesco {

/// Objects and recursives as they are built on one another. Each stands on at most one other by name (through an
/// assignment, its sets, or `w n`, which stands on w's base), so they are the nodes of a forest.
struct ObjectNode {
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    /// Nameless for <$>.
    NameId name = NameTable::nameless;
    /// The line (from 0) that declares it.
    std::uint32_t line = 0;
    bool isRecursive = false;
    bool isBad = false;
    bool isMesh = false;

    /// Own sets [firstSet, endSet), outermost first; then a mesh, or `repeated` count times, or nothing between them and
    /// `next`.
    SetId firstSet = 0;
    SetId endSet = 0;
    std::uint32_t repeated = none;
    std::uint64_t count = 0;

    /// What it stands on by name.
    std::uint32_t next = none;
    /// For a recursive, its base.
    std::uint32_t base = none;

    /// Number of nodes below, and one of them far below: looking for a node takes a logarithm of steps
    /// (Myers 1983, an applicative random-access stack).
    std::uint32_t height = 0;
    std::uint32_t jump = none;
    /// Levels from here to the mesh, held at the greatest value where there are more.
    Position levels = 0;
    /// For a recursive, levels of one iteration.
    Position iterationLevels = 0;
};

/// A name or a path as part of a longer message: of a long one only the start.
[[nodiscard]] std::string shortened(std::string_view words);

class ObjectForest
{
public:
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(m_nodes.size()); }
    [[nodiscard]] const ObjectNode &operator[](std::uint32_t index) const { return m_nodes[index]; }

    /// Adds a node whose sets, inner part and next are filled in, and works out the rest.
    std::uint32_t add(ObjectNode node);

    /// Whether `other` is `node` itself or stands under it.
    [[nodiscard]] bool standsOn(std::uint32_t node, std::uint32_t other) const;

    /// "y → k → a", from the node down to the one that holds the mesh, shortened in the middle, long names too. Costs a
    /// logarithm of the nodes.
    [[nodiscard]] std::string chain(std::uint32_t node, const NameTable &names) const;

    /// All levels from the node down to its mesh. Iterative; cost linear in the nodes passed.
    /// Precondition: node.levels is not held at the greatest value.
    void writeLevels(std::uint32_t node, LevelSequence::Builder &builder) const;

    /// Where a level of a node comes from.
    struct Origin {
        /// The node in whose line the set is written, and the set.
        std::uint32_t node = ObjectNode::none;
        SetId set = 0;
        /// The recursives round it, outermost first, each with the pass (from 0) of its iteration.
        struct Pass {
            std::uint32_t recursive = ObjectNode::none;
            std::uint64_t pass = 0;
        };
        std::vector<Pass> passes;
    };
    /// Position counts from the node inwards, below its levels, which must not be held at the greatest value. Cost: a
    /// logarithm of the nodes for each recursive round it.
    [[nodiscard]] Origin origin(std::uint32_t node, Position position) const;

    /// The node that holds the mesh under a node. Costs a logarithm of the nodes.
    [[nodiscard]] std::uint32_t meshNode(std::uint32_t node) const;

private:
    /// The node of that height under a node, or itself.
    [[nodiscard]] std::uint32_t below(std::uint32_t node, std::uint32_t height) const;

    std::vector<ObjectNode> m_nodes;
};

}
