// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fractalgraph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <ranges>
#include <unordered_map>

#include "core/geometry/computable.h"

namespace romanesco {

std::expected<FractalGraph, SourceRange> FractalGraph::build(const FractalDescription &description, const Sphere &base)
{
    FractalGraph graph;
    graph.m_levels = description.levels;
    graph.m_sets = description.sets;
    graph.dropUnusedSets();
    for (const TransformSet &set : graph.m_sets) {
        std::vector<MapFacts> &facts = graph.m_facts.emplace_back();
        facts.reserve(set.maps.size());
        for (const AffineMap &map : set.maps) {
            facts.push_back(factsOf(map));
        }
    }
    graph.classifyMaps();
    graph.findEqualSets();
    graph.findLastFixedLevel();
    graph.m_bounds = SphereBounds(graph, base);

    const Sphere whole = graph.bound(0);
    if (isComputable(whole.centre, whole.radius)) {
        return graph;
    }
    return std::unexpected(graph.strongestGrowth().value_or(description.meshRange));
}

/// The transformation that enlarges most; where none does, the one that moves farthest, if that is farther than the mesh
/// reaches.
std::optional<SourceRange> FractalGraph::strongestGrowth() const
{
    std::optional<SourceRange> strongest;
    std::optional<SourceRange> farthest;
    double largestNorm = 1.0;
    double largestMove =
        std::max({std::abs(base().centre.x), std::abs(base().centre.y), std::abs(base().centre.z), base().radius});
    for (std::size_t i = 0; i < m_sets.size(); ++i) {
        for (std::size_t j = 0; j < m_facts[i].size(); ++j) {
            if (m_facts[i][j].norm > largestNorm) {
                largestNorm = m_facts[i][j].norm;
                strongest = m_sets[i].uses[j];
            }
            const glm::dvec3 &move = m_sets[i].maps[j].translation;
            const double largest = std::max({std::abs(move.x), std::abs(move.y), std::abs(move.z)});
            if (largest > largestMove) {
                largestMove = largest;
                farthest = m_sets[i].uses[j];
            }
        }
    }
    return strongest ? strongest : farthest;
}

FractalGraph FractalGraph::ofMesh(const Sphere &base)
{
    FractalGraph graph;
    graph.m_levels = LevelSequence::Builder().build();
    graph.m_bounds = SphereBounds(graph, base);
    return graph;
}

/// A text may hold sets that are in no level of its result; they say nothing about it.
void FractalGraph::dropUnusedSets()
{
    std::vector<bool> isUsed(m_sets.size());
    for (LevelSequence::Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
        isUsed[m_levels.set(slot)] = true;
    }
    for (SetId id = 0; id < m_sets.size(); ++id) {
        if (!isUsed[id]) {
            m_sets[id] = {};
        }
    }
}

void FractalGraph::classifyMaps()
{
    std::unordered_map<AffineMap, std::uint32_t, AffineMapHash> classes;
    for (const TransformSet &set : m_sets) {
        std::vector<std::uint32_t> &numbers = m_mapClasses.emplace_back();
        numbers.reserve(set.maps.size());
        for (const AffineMap &map : set.maps) {
            numbers.push_back(classes.try_emplace(map, static_cast<std::uint32_t>(classes.size())).first->second);
        }
    }
    m_mapClassCount = static_cast<std::uint32_t>(classes.size());
}

void FractalGraph::findEqualSets()
{
    std::map<std::pair<std::vector<std::uint32_t>, bool>, SetId> known;
    std::vector<SetId> owner(m_mapClassCount, static_cast<SetId>(m_sets.size()));
    for (SetId id = 0; id < m_sets.size(); ++id) {
        std::vector<std::uint32_t> content = m_mapClasses[id];
        std::ranges::sort(content);
        const SetId first = known.try_emplace({std::move(content), m_sets[id].holdsIdentity}, id).first->second;
        m_canonical.push_back(first);
        m_distinctSetCount += first == id && m_sets[id].size() != 0 ? 1 : 0;
        for (const std::uint32_t number : m_mapClasses[id]) {
            m_setsShareMaps = m_setsShareMaps || (owner[number] != m_sets.size() && owner[number] != first);
            owner[number] = first;
        }
    }
}

/// The last position whose level cannot be passed over lies in the last pass of each repeat round its slot: found from
/// the end of the whole inwards, over whole repeats that can be passed and into the last that cannot.
void FractalGraph::findLastFixedLevel()
{
    using Slot = LevelSequence::Slot;
    const std::vector<LevelSequence::Repeat> &repeats = m_levels.repeats();
    const auto holdsIdentity = [&](Slot slot) { return setAt(slot).holdsIdentity; };
    m_passableFrom = m_levels.levelCount();
    std::uint32_t at = 0;
    Slot slot = repeats[at].endSlot;
    std::size_t inner = repeats[at].inner.size();
    while (slot > repeats[at].firstSlot) {
        const std::uint32_t last = inner > 0 ? repeats[at].inner[inner - 1] : 0;
        const bool endsRepeat = inner > 0 && repeats[last].endSlot == slot;
        if (!endsRepeat) {
            if (!holdsIdentity(slot - 1)) {
                return;
            }
            --slot;
            --m_passableFrom;
        } else if (std::ranges::all_of(std::views::iota(repeats[last].firstSlot, slot), holdsIdentity)) {
            slot = repeats[last].firstSlot;
            m_passableFrom -= repeats[last].length();
            --inner;
        } else {
            at = last;
            inner = repeats[at].inner.size();
        }
    }
}

FractalGraph::Reach FractalGraph::reach(Position position) const
{
    Reach reach;
    reach.reachesEnd = position >= m_passableFrom;
    std::vector<bool> seenSlots;
    boost::container::small_vector<SetId, 8> seenSets;
    while (position < m_levels.levelCount()) {
        const auto [slot, repeat, end] = m_levels.locate(position);
        // A slot seen before: a whole pass of the repeat round it has gone by, and the other passes are like it.
        if (!seenSlots.empty() && seenSlots[slot]) {
            position = end;
            continue;
        }
        const SetId set = m_canonical[m_levels.set(slot)];
        if (std::ranges::find(seenSets, set) == seenSets.end()) {
            seenSets.push_back(set);
            reach.levels.push_back({position, slot});
        }
        const bool isComplete = reach.reachesEnd && seenSets.size() == m_distinctSetCount;
        if (!setAt(slot).holdsIdentity || isComplete) {
            break;
        }
        seenSlots.resize(m_levels.slotCount());
        seenSlots[slot] = true;
        ++position;
    }
    reach.last = reach.reachesEnd ? m_levels.levelCount() : position;
    return reach;
}

std::size_t FractalGraph::memoryUse() const
{
    std::size_t bytes = sizeof(*this) + m_bounds.memoryUse();
    for (std::size_t i = 0; i < m_sets.size(); ++i) {
        bytes += m_sets[i].maps.size() * (sizeof(AffineMap) + sizeof(SourceRange) + sizeof(MapFacts) + sizeof(int));
    }
    return bytes + 4 * sizeof(LevelSequence::Slot) * m_levels.slotCount();
}

}
