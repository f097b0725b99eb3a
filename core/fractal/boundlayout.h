// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/formats/levelsequence.h"

namespace romanesco {

class FractalGraph;

/// Which positions of a sequence of levels share a bound, and what each bound has to hold: a small graph whose *nodes*
/// stand for one position or for many, and whose *steps* lead to the nodes that may follow.
///
/// The sequence falls into *stretches*: all passes of an outermost repeat, or the plain levels between two of them. In a
/// stretch the last positions have a node each. Those before them share the node of their slot; or they have none: where
/// maps do not contract no bound is good for all of them, and the stretch is said to *grow*.
class BoundLayout
{
public:
    using Node = std::uint32_t;
    using Slot = LevelSequence::Slot;

    /// The end of the sequence, where the base mesh stands.
    static constexpr Node end = 0;

    /// What follows a node: the maps of a slot's set and then another node. Where the set holds `#`, also that node
    /// itself.
    struct Step {
        Slot slot;
        Node next;
    };

    struct Stretch {
        Position begin = 0;
        Position end = 0;
        Slot firstSlot = 0;
        Slot endSlot = 0;
        /// The nodes of the last positions: firstOwn is that of the last one, the next number that of the one before.
        Node firstOwn = 0;
        Position ownCount = 0;
        /// Nodes that positions share: none where all have their own, or where the stretch grows.
        Node firstShared = 0;
        std::uint32_t sharedCount = 0;
        /// The nodes at begin and at end.
        Node entry = 0;
        Node exit = 0;
    };

    /// The last of the sequence first.
    [[nodiscard]] const std::vector<Stretch> &stretches() const { return m_stretches; }
    /// The node of position 0.
    [[nodiscard]] Node entry() const { return m_stretches.empty() ? end : m_stretches.back().entry; }
    [[nodiscard]] std::size_t nodeCount() const { return m_firstStep.size() - 1; }

    /// From a node of one position to the one before it in number; from a shared one to those shared in the same stretch,
    /// and to the stretch's last own; from the end, and from the entry of a stretch that grows, nowhere.
    [[nodiscard]] std::span<const Step> steps(Node node) const
    {
        return std::span(m_steps).subspan(m_firstStep[node], m_firstStep[node + 1] - m_firstStep[node]);
    }

    /// The stretch of a position below levelCount().
    [[nodiscard]] const Stretch &stretchAt(Position position) const;

    /// Nothing in a stretch that grows, before its own nodes. Cost: some binary searches.
    [[nodiscard]] std::optional<Node> nodeAt(const LevelSequence &levels, Position position) const;

    [[nodiscard]] std::size_t memoryUse() const;

    class Builder;

private:
    std::vector<Stretch> m_stretches;
    /// By slot.
    std::vector<Node> m_sharedNode;
    std::vector<Step> m_steps;
    std::vector<std::uint32_t> m_firstStep{0, 0};
};

/// Makes a layout, one stretch after another from the last one, since whether nodes can be shared shows only when their
/// bounds are computed.
class BoundLayout::Builder
{
public:
    /// For a graph whose levels, sets and facts are there.
    explicit Builder(const FractalGraph &graph);

    [[nodiscard]] std::size_t stretchCount() const { return m_layout.m_stretches.size(); }
    [[nodiscard]] const BoundLayout &layout() const { return m_layout; }
    [[nodiscard]] BoundLayout build() && { return std::move(m_layout); }

    /// Begins with a stretch, which has no nodes yet.
    void begin(std::size_t stretch);

    /// Whether another position may have a node of its own: not with 4,096 in a repeat, nor with a million maps in all.
    [[nodiscard]] bool canAddOwn(std::size_t stretch) const;
    /// A node for the last position that has none. Returns what its maps leave of a length at most, `#` left out.
    double addOwn(std::size_t stretch);

    /// Whether all positions have their own now.
    [[nodiscard]] bool isWhole(std::size_t stretch) const;

    /// Whether it has repeats in a repeat, of which shared nodes forget how often they go round, and few positions.
    [[nodiscard]] bool isShortNest(std::size_t stretch) const;

    /// Whether every way round a repeat contracts, so that nodes may be shared.
    [[nodiscard]] bool contracts(std::size_t stretch) const;
    void addShared(std::size_t stretch);

    /// The node at the begin of a stretch that grows; in place of shared ones, if there are any.
    void addGrown(std::size_t stretch);

private:
    void findStretches();
    Node addNode(std::span<const Step> steps);
    [[nodiscard]] std::vector<Slot> groupsOf(const Stretch &stretch) const;
    [[nodiscard]] bool contracts(const LevelSequence::Repeat &repeat) const;

    const FractalGraph &m_graph;
    BoundLayout m_layout;
    /// By slot, `#` left out; 1 where there is no map.
    std::vector<double> m_largestNorm;
    std::size_t m_mapCount = 0;
};

}
