// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "fractalgraph.h"

namespace romanesco {

using StateId = std::uint32_t;

/// A state of the graph: what may still follow the picks made so far. Nearly always a single position; several where a
/// map is shared by a set that may be passed over and one that may not, so that the same picks fit in more than one way
/// (the usual subset construction). Positions ascend, and none can be reached from another by passing levels over.
struct State {
    std::vector<Position> positions;
    /// A sphere round everything below, in the state's own frame.
    Sphere bound;
};

/// Children of a state that share a set and a following state: maps [firstMap, endMap) of a set.
struct ChildRange {
    SetId set;
    std::uint32_t firstMap;
    std::uint32_t endMap;
    StateId next;
};

/// The children of a state, each canonical continuation once, in a fixed order.
struct Expansion {
    std::vector<ChildRange> ranges;
    /// A sphere round each child in the state's frame, by range and map.
    std::vector<Sphere> bounds;
    /// The word may end here: the base mesh stands in this frame.
    bool hasLeaf = false;
};

/// The states of a graph, made as they are asked for and each only once. Memory grows with the states visited, not with
/// the depth; forget() returns it. One thread uses it; the graph must outlive it.
class StateTable
{
public:
    explicit StateTable(const FractalGraph &graph);

    [[nodiscard]] const FractalGraph &graph() const { return m_graph; }
    [[nodiscard]] StateId root() const { return 0; }
    [[nodiscard]] const State &state(StateId id) const { return m_states[id].state; }

    /// Expanded on the first call. References stay valid until forget().
    const Expansion &expansion(StateId id);

    /// The state with these positions, which must be as State describes; made if it is new.
    StateId find(std::vector<Position> positions);

    [[nodiscard]] std::size_t stateCount() const { return m_states.size(); }
    [[nodiscard]] std::size_t memoryUse() const { return m_bytes; }

    /// Back to the root alone; every StateId but root() is void.
    void forget();

private:
    struct Entry {
        State state;
        Expansion expansion;
        bool isExpanded = false;
    };

    void normalise(std::vector<Position> &positions) const;
    void expand(Entry &entry);
    void expandDistinct(const FractalGraph::Reach &reach, Expansion &expansion);
    void expandShared(std::span<const FractalGraph::Reach> reaches, Expansion &expansion);

    const FractalGraph &m_graph;
    std::deque<Entry> m_states;
    std::map<std::vector<Position>, StateId> m_ids;
    std::size_t m_bytes = 0;
};

}
