// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "fractalgraph.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace romanesco {

std::expected<FractalGraph, SourceRange> FractalGraph::build(const FractalDescription &description, const Sphere &base)
{
    FractalGraph graph;
    graph.m_levels = description.levels;
    graph.m_sets = description.sets;
    for (const TransformSet &set : graph.m_sets) {
        std::vector<double> &norms = graph.m_norms.emplace_back();
        norms.reserve(set.maps.size());
        for (const AffineMap &map : set.maps) {
            norms.push_back(operatorNorm(map.linear));
        }
    }
    graph.classifyMaps();
    graph.findEqualSets();
    graph.findLastFixedLevel();
    graph.m_bounds = SphereBounds(graph.m_levels, graph.m_sets, graph.m_norms, base);

    const Sphere whole = graph.bound(0);
    if (std::isfinite(whole.radius) && std::isfinite(whole.radius * whole.radius)) {
        return graph;
    }
    SourceRange strongest = description.meshRange;
    double largest = 1.0;
    for (std::size_t i = 0; i < graph.m_sets.size(); ++i) {
        for (std::size_t j = 0; j < graph.m_norms[i].size(); ++j) {
            if (graph.m_norms[i][j] > largest) {
                largest = graph.m_norms[i][j];
                strongest = graph.m_sets[i].uses[j];
            }
        }
    }
    return std::unexpected(strongest);
}

FractalGraph FractalGraph::ofMesh(const Sphere &base)
{
    FractalGraph graph;
    graph.m_levels = LevelSequence::Builder().build();
    graph.m_bounds = SphereBounds(graph.m_levels, graph.m_sets, graph.m_norms, base);
    return graph;
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
        m_distinctSetCount += first == id ? 1 : 0;
        for (const std::uint32_t number : m_mapClasses[id]) {
            m_setsShareMaps = m_setsShareMaps || (owner[number] != m_sets.size() && owner[number] != first);
            owner[number] = first;
        }
    }
}

/// The last position whose level cannot be passed over lies in the last pass of each repeat round its slot.
void FractalGraph::findLastFixedLevel()
{
    Position position = m_levels.levelCount();
    while (position > 0) {
        const auto [slot, index, end] = m_levels.locate(position - 1);
        if (!setAt(slot).holdsIdentity) {
            break;
        }
        const LevelSequence::Repeat &repeat = m_levels.repeats()[index];
        const bool isWholePass = slot == repeat.firstSlot && index != 0 && end - (position - 1) == repeat.passLength;
        position = isWholePass ? end - repeat.length() : position - 1;
    }
    m_passableFrom = position;
}

FractalGraph::Reach FractalGraph::reach(Position position) const
{
    Reach reach;
    reach.reachesEnd = position >= m_passableFrom;
    std::vector<bool> seenSlots(m_levels.slotCount());
    std::vector<SetId> seenSets;
    while (position < m_levels.levelCount()) {
        const auto [slot, repeat, end] = m_levels.locate(position);
        // A slot seen before: a whole pass of the repeat round it has gone by, and the other passes are like it.
        if (seenSlots[slot]) {
            position = end;
            continue;
        }
        seenSlots[slot] = true;
        const SetId set = m_canonical[m_levels.set(slot)];
        if (std::ranges::find(seenSets, set) == seenSets.end()) {
            seenSets.push_back(set);
            reach.levels.push_back({position, slot});
        }
        const bool isComplete = reach.reachesEnd && seenSets.size() == m_distinctSetCount;
        if (!setAt(slot).holdsIdentity || isComplete) {
            break;
        }
        ++position;
    }
    reach.last = reach.reachesEnd ? m_levels.levelCount() : position;
    return reach;
}

std::size_t FractalGraph::memoryUse() const
{
    std::size_t bytes = sizeof(*this) + m_bounds.memoryUse();
    for (std::size_t i = 0; i < m_sets.size(); ++i) {
        bytes += m_sets[i].maps.size() * (sizeof(AffineMap) + sizeof(SourceRange) + sizeof(double) + sizeof(int));
    }
    return bytes + m_levels.slotCount() * 4 * sizeof(LevelSequence::Slot);
}

}
