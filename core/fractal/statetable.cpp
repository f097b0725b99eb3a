// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "statetable.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>

#include <glm/geometric.hpp>

namespace romanesco {

const Sphere &standIn(const Sphere &base, const Sphere &bound)
{
    return glm::distance(bound.centre, base.centre) + base.radius > 1.1 * bound.radius ? bound : base;
}

void placePicks(const FractalGraph &graph, std::span<const Positions> reached, std::span<Pick> picks)
{
    const auto mapClassOf = [&](const Pick &pick) {
        return graph.mapClasses(graph.levels().set(graph.levels().locate(pick.position).slot))[pick.map];
    };
    Position after = graph.levels().levelCount();
    for (std::size_t i = picks.size(); i-- > 0;) {
        const bool isLast = i + 1 == picks.size();
        const auto found = std::ranges::find_if(reached[i], [&](Position position) {
            const FractalGraph::Reach reach = graph.reach(position);
            const auto isTaken = [&](const auto &level) { return level.position + 1 == after; };
            return isLast ? reach.reachesEnd : std::ranges::any_of(reach.levels, isTaken);
        });
        assert((isLast || found != reached[i].end()) && "each pick follows the one before");
        after = found != reached[i].end() ? *found : reached[i].front(); // a word may end early
        const std::uint32_t mapClass = mapClassOf(picks[i]);
        picks[i] = {after - 1, 0};
        while (mapClassOf(picks[i]) != mapClass) {
            ++picks[i].map;
        }
    }
}

StateTable::StateTable(const FractalGraph &graph)
    : m_graph(graph)
{
    forget();
}

void StateTable::forget()
{
    m_states.clear();
    m_ids.clear();
    m_bytes = 0;
    find({0});
}

void StateTable::forgetAllBut(std::span<StateId> ids)
{
    std::vector<Positions> kept;
    kept.reserve(ids.size());
    for (const StateId id : ids) {
        kept.push_back(state(id).positions);
    }
    forget();
    for (std::size_t i = 0; i < ids.size(); ++i) {
        ids[i] = find(std::move(kept[i]));
    }
}

std::size_t StateTable::Hash::operator()(const Positions &positions) const
{
    std::uint64_t hash = 0;
    for (const Position position : positions) {
        hash = (hash ^ position) * 0x9E3779B97F4A7C15u;
        hash ^= hash >> 32;
    }
    return hash;
}

const Expansion &StateTable::expansion(StateId id)
{
    Entry &entry = m_states[id];
    if (!entry.isExpanded) {
        expand(entry);
    }
    return entry.expansion;
}

const std::vector<Sphere> &StateTable::childBounds(StateId id)
{
    std::vector<Sphere> &bounds = m_states[id].childBounds;
    if (bounds.empty()) {
        for (const ChildRange &range : expansion(id).ranges) {
            const Sphere bound = state(range.next).bound;
            for (std::uint32_t map = range.firstMap; map < range.endMap; ++map) {
                bounds.push_back(
                    transformed(m_graph.set(range.set).maps[map], m_graph.facts(range.set)[map].norm, bound));
            }
        }
        m_bytes += bounds.size() * sizeof(Sphere);
    }
    return bounds;
}

StateId StateTable::find(Positions positions)
{
    const auto [known, isNew] = m_ids.try_emplace(std::move(positions), static_cast<StateId>(m_states.size()));
    if (isNew) {
        const Positions &places = known->first;
        boost::container::small_vector<Sphere, 1> bounds;
        for (const Position position : places) {
            bounds.push_back(m_graph.bound(position));
        }
        m_states.emplace_back().state = {places, bounds.size() == 1 ? bounds.front() : enclosingSphere(bounds)};
        m_bytes += sizeof(Entry) + sizeof(*known) + 3 * sizeof(void *);
        m_bytes += places.size() > 1 ? 2 * places.size() * sizeof(Position) : 0;
    }
    return known->second;
}

/// Keeps of several positions those that are not reached from an earlier one by passing levels over: what can follow
/// them can follow the earlier one too.
void StateTable::normalise(Positions &positions) const
{
    std::ranges::sort(positions);
    Positions kept;
    Position reached = 0;
    for (const Position position : positions) {
        if (!kept.empty() && position <= reached) {
            continue;
        }
        reached = m_graph.reach(position).last;
        kept.push_back(position);
    }
    positions = std::move(kept);
}

void StateTable::expand(Entry &entry)
{
    Expansion &expansion = entry.expansion;
    boost::container::small_vector<FractalGraph::Reach, 1> reaches;
    for (const Position position : entry.state.positions) {
        reaches.push_back(m_graph.reach(position));
        expansion.hasLeaf = expansion.hasLeaf || reaches.back().reachesEnd;
    }
    if (m_graph.setsShareMaps()) {
        expandShared(reaches, expansion);
    } else {
        expandDistinct(reaches.front(), expansion);
    }
    m_bytes += expansion.ranges.size() > 2 ? expansion.ranges.size() * sizeof(ChildRange) : 0;
    entry.isExpanded = true;
}

/// Different sets hold different maps: each whole.
void StateTable::expandDistinct(const FractalGraph::Reach &reach, Expansion &expansion)
{
    for (const auto &[position, slot] : reach.levels) {
        const SetId set = m_graph.levels().set(slot);
        const auto size = static_cast<std::uint32_t>(m_graph.set(set).maps.size());
        if (size != 0) {
            expansion.ranges.push_back({set, 0, size, find({position + 1})});
        }
    }
}

/// A map may occur in several of the levels: one child for each map, whose state is all that may follow it.
void StateTable::expandShared(std::span<const FractalGraph::Reach> reaches, Expansion &expansion)
{
    struct Child {
        SetId set;
        std::uint32_t map;
        Positions next;
    };
    std::vector<Child> children;
    std::unordered_map<std::uint32_t, std::size_t> childOfClass;
    for (const FractalGraph::Reach &reach : reaches) {
        for (const auto &[position, slot] : reach.levels) {
            const SetId set = m_graph.levels().set(slot);
            const std::vector<std::uint32_t> &classes = m_graph.mapClasses(set);
            for (std::uint32_t map = 0; map < classes.size(); ++map) {
                const auto [known, isNew] = childOfClass.try_emplace(classes[map], children.size());
                if (isNew) {
                    children.push_back({set, map, {}});
                }
                children[known->second].next.push_back(position + 1);
            }
        }
    }
    for (Child &child : children) {
        if (child.next.size() > 1) {
            normalise(child.next);
        }
        expansion.ranges.push_back({child.set, child.map, child.map + 1, find(std::move(child.next))});
    }
}

std::optional<Address> addressOf(StateTable &table, std::span<const Step> steps)
{
    Address address;
    std::vector<Positions> reached;
    StateId state = table.root();
    for (const Step &step : steps) {
        const auto leads = [&](const ChildRange &range) {
            return range.set == step.set && range.firstMap <= step.map && step.map < range.endMap;
        };
        const auto &ranges = table.expansion(state).ranges;
        const auto range = std::ranges::find_if(ranges, leads);
        if (range == ranges.end()) {
            return std::nullopt;
        }
        state = range->next;
        reached.push_back(table.state(state).positions);
        address.push_back({reached.back().front() - 1, step.map});
    }
    if (table.graph().setsShareMaps()) {
        placePicks(table.graph(), reached, address);
    }
    return address;
}

}
