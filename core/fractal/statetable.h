// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "address.h"
#include "fractalgraph.h"
#include "step.h"

namespace romanesco {

using StateId = std::uint32_t;
using Positions = boost::container::small_vector<Position, 1>;

/// A state of the graph: what may still follow the picks made so far. Nearly always a single position; several where a
/// map is shared by a set that may be passed over and one that may not, so that the same picks fit in more than one way
/// (the usual subset construction). Positions ascend, and none can be reached from another by passing levels over.
struct State {
    Positions positions;
    /// A sphere round everything below, in the state's own frame.
    Sphere bound;
};

/// Where a base mesh, in its own sphere, stands for all that is in a bound, which is too small to tell more: at its place,
/// or fitted into the bound where it reaches far out of it, as a last level may move or shrink it far. A tenth of the
/// bound's radius beyond it at most.
[[nodiscard]] const Sphere &standIn(const Sphere &base, const Sphere &bound);

/// Children of a state that share a set and a following state: maps [firstMap, endMap) of a set.
struct ChildRange {
    SetId set;
    std::uint32_t firstMap;
    std::uint32_t endMap;
    StateId next;
};

/// The children of a state, each canonical continuation once, in a fixed order.
struct Expansion {
    boost::container::small_vector<ChildRange, 2> ranges;
    /// The word may end here: the base mesh stands in this frame.
    bool hasLeaf = false;
};

/// Which of several levels a map was taken from that sets share shows only at the end of the word: puts each pick at its
/// level, from the end backwards. reached: the positions of the state that each pick led to.
void placePicks(const FractalGraph &graph, std::span<const Positions> reached, std::span<Pick> picks);

/// The states of a graph, made as they are asked for and each only once. Memory grows with the states visited, not with
/// the depth; forget() returns it. One thread uses it; the graph must outlive it.
class StateTable
{
public:
    explicit StateTable(const FractalGraph &graph);

    [[nodiscard]] const FractalGraph &graph() const { return m_graph; }
    [[nodiscard]] StateId root() const { return 0; }
    [[nodiscard]] const State &state(StateId id) const { return m_states[id].state; }

    /// Expanded on the first call. References stay valid until states are forgotten.
    const Expansion &expansion(StateId id);

    /// A sphere round each child in the state's frame, by range and map; made on the first call.
    const std::vector<Sphere> &childBounds(StateId id);

    /// The state with these positions, which must be as State describes; made if it is new.
    StateId find(Positions positions);

    [[nodiscard]] std::size_t stateCount() const { return m_states.size(); }
    [[nodiscard]] std::size_t memoryUse() const { return m_bytes; }

    /// Back to the root alone; every StateId but root() is void.
    void forget();

    /// Back to the root and these, which get their new numbers and are no longer expanded.
    void forgetAllBut(std::span<StateId> ids);

private:
    struct Entry {
        State state;
        bool isExpanded = false;
        Expansion expansion;
        std::vector<Sphere> childBounds;
    };
    struct Hash {
        std::size_t operator()(const Positions &positions) const;
    };

    void normalise(Positions &positions) const;
    void expand(Entry &entry);
    void expandDistinct(const FractalGraph::Reach &reach, Expansion &expansion);
    void expandShared(std::span<const FractalGraph::Reach> reaches, Expansion &expansion);

    const FractalGraph &m_graph;
    std::deque<Entry> m_states;
    std::unordered_map<Positions, StateId, Hash> m_ids;
    std::size_t m_bytes = 0;
};

/// The address of a way down from the root; nothing where there is no such way. Cost: the states passed are expanded.
[[nodiscard]] std::optional<Address> addressOf(StateTable &table, std::span<const Step> steps);

}
