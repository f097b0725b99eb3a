// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "boundlayout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <ranges>
#include <set>

#include "fractalgraph.h"

namespace romanesco {

namespace {

constexpr Position longestTail = 4'096;
constexpr Position longestNest = 256;
constexpr std::size_t mostMaps = 1'000'000;

/// Whether no level comes twice.
bool isPlain(const BoundLayout::Stretch &stretch)
{
    return stretch.end - stretch.begin == stretch.endSlot - stretch.firstSlot;
}

}

const BoundLayout::Stretch &BoundLayout::stretchAt(Position position) const
{
    const auto found =
        std::ranges::partition_point(m_stretches, [&](const Stretch &stretch) { return stretch.begin > position; });
    assert(found != m_stretches.end() && position < found->end && "stretches cover all positions but the end");
    return *found;
}

std::optional<BoundLayout::Node> BoundLayout::nodeAt(const LevelSequence &levels, Position position) const
{
    if (position == levels.levelCount()) {
        return end;
    }
    const Stretch &stretch = stretchAt(position);
    const Position remaining = stretch.end - position;
    if (remaining <= stretch.ownCount) {
        return static_cast<Node>(stretch.firstOwn + remaining - 1);
    }
    return stretch.sharedCount == 0 ? std::nullopt : std::optional(m_sharedNode[levels.locate(position).slot]);
}

std::size_t BoundLayout::memoryUse() const
{
    return m_stretches.capacity() * sizeof(Stretch) + m_steps.capacity() * sizeof(Step)
        + m_firstStep.capacity() * sizeof(std::uint32_t) + m_sharedNode.capacity() * sizeof(Node);
}

BoundLayout::Builder::Builder(const FractalGraph &graph)
    : m_graph(graph)
{
    const LevelSequence &levels = graph.levels();
    for (Slot slot = 0; slot < levels.slotCount(); ++slot) {
        const std::vector<MapFacts> &facts = graph.facts(levels.set(slot));
        m_largestNorm.push_back(facts.empty() ? 1.0 : std::ranges::max(facts, {}, &MapFacts::norm).norm);
    }
    findStretches();
}

void BoundLayout::Builder::findStretches()
{
    const std::vector<LevelSequence::Repeat> &repeats = m_graph.levels().repeats();
    std::vector<Stretch> &stretches = m_layout.m_stretches;
    Position position = 0;
    Slot slot = 0;
    const auto add = [&](Slot endSlot, Position length) {
        if (endSlot != slot) {
            stretches.push_back({.begin = position, .end = position + length, .firstSlot = slot, .endSlot = endSlot});
            position += length;
            slot = endSlot;
        }
    };
    for (const std::uint32_t outermost : repeats[0].inner) {
        const LevelSequence::Repeat &repeat = repeats[outermost];
        add(repeat.firstSlot, repeat.firstSlot - slot);
        add(repeat.endSlot, repeat.length());
    }
    add(repeats[0].endSlot, repeats[0].endSlot - slot);
    assert(position == m_graph.levels().levelCount() && "stretches cover all levels");
    std::ranges::reverse(stretches);
}

BoundLayout::Node BoundLayout::Builder::addNode(std::span<const Step> steps)
{
    m_layout.m_steps.insert(m_layout.m_steps.end(), steps.begin(), steps.end());
    m_layout.m_firstStep.push_back(static_cast<std::uint32_t>(m_layout.m_steps.size()));
    return static_cast<Node>(m_layout.nodeCount() - 1);
}

void BoundLayout::Builder::begin(std::size_t index)
{
    Stretch &stretch = m_layout.m_stretches[index];
    stretch.exit = index == 0 ? end : m_layout.m_stretches[index - 1].entry;
    stretch.entry = stretch.exit;
    stretch.firstOwn = static_cast<Node>(m_layout.nodeCount());
}

bool BoundLayout::Builder::canAddOwn(std::size_t index) const
{
    const Stretch &stretch = m_layout.m_stretches[index];
    return !isWhole(index) && m_mapCount <= mostMaps && (isPlain(stretch) || stretch.ownCount < longestTail);
}

double BoundLayout::Builder::addOwn(std::size_t index)
{
    Stretch &stretch = m_layout.m_stretches[index];
    assert(canAddOwn(index) && "there is a position without a node, and room for it");
    ++stretch.ownCount;
    const Slot slot = m_graph.levels().locate(stretch.end - stretch.ownCount).slot;
    stretch.entry = addNode(std::array{Step{slot, stretch.entry}});
    m_mapCount += m_graph.setAt(slot).size();
    return m_largestNorm[slot];
}

bool BoundLayout::Builder::isWhole(std::size_t index) const
{
    const Stretch &stretch = m_layout.m_stretches[index];
    return stretch.ownCount == stretch.end - stretch.begin;
}

bool BoundLayout::Builder::isShortNest(std::size_t index) const
{
    const Stretch &stretch = m_layout.m_stretches[index];
    const std::vector<LevelSequence::Repeat> &repeats = m_graph.levels().repeats();
    const auto isInside = [&](const LevelSequence::Repeat &repeat) {
        return repeat.firstSlot >= stretch.firstSlot && repeat.endSlot <= stretch.endSlot;
    };
    return stretch.end - stretch.begin <= longestNest && std::ranges::count_if(repeats, isInside) > 1;
}

bool BoundLayout::Builder::contracts(std::size_t index) const
{
    const Stretch &stretch = m_layout.m_stretches[index];
    if (isPlain(stretch)) {
        return false; // nor is there anything to share
    }
    return std::ranges::all_of(m_graph.levels().repeats(), [&](const LevelSequence::Repeat &repeat) {
        const bool isInside = repeat.firstSlot >= stretch.firstSlot && repeat.endSlot <= stretch.endSlot;
        return !isInside || repeat.count == 1 || contracts(repeat);
    });
}

/// Where all levels may be passed over each map has to contract by itself; else all levels together, those passed over
/// or not.
bool BoundLayout::Builder::contracts(const LevelSequence::Repeat &repeat) const
{
    bool allHoldIdentity = true;
    double largest = 0.0;
    double product = 1.0;
    for (Slot slot = repeat.firstSlot; slot < repeat.endSlot; ++slot) {
        const TransformSet &set = m_graph.setAt(slot);
        allHoldIdentity = allHoldIdentity && set.holdsIdentity;
        largest = std::max(largest, set.maps.empty() ? 0.0 : m_largestNorm[slot]);
        product *= set.holdsIdentity ? std::max(1.0, m_largestNorm[slot]) : m_largestNorm[slot];
    }
    return (allHoldIdentity ? largest : product) < 1.0;
}

/// For each slot of a stretch the one that stands for it. Slots that can reach one another by passing levels over are
/// bounded alike: all slots of a repeat in which every level holds `#`; the first slot of the outermost such repeat.
std::vector<BoundLayout::Slot> BoundLayout::Builder::groupsOf(const Stretch &stretch) const
{
    std::vector<Slot> groups(stretch.endSlot - stretch.firstSlot);
    std::ranges::copy(std::views::iota(stretch.firstSlot, stretch.endSlot), groups.begin());
    // Inner repeats have greater numbers than those round them, which have their say last.
    for (const LevelSequence::Repeat &repeat : m_graph.levels().repeats() | std::views::reverse) {
        const bool isInside = repeat.firstSlot >= stretch.firstSlot && repeat.endSlot <= stretch.endSlot;
        const auto slots = std::views::iota(repeat.firstSlot, repeat.endSlot);
        const auto holdsIdentity = [&](Slot slot) { return m_graph.setAt(slot).holdsIdentity; };
        if (isInside && repeat.count > 1 && std::ranges::all_of(slots, holdsIdentity)) {
            std::ranges::fill(std::span(groups).subspan(repeat.firstSlot - stretch.firstSlot, slots.size()),
                              repeat.firstSlot);
        }
    }
    return groups;
}

void BoundLayout::Builder::addShared(std::size_t index)
{
    const LevelSequence &levels = m_graph.levels();
    Stretch &stretch = m_layout.m_stretches[index];
    assert(!isWhole(index) && "positions are left that can share nodes");
    const std::vector<Slot> groups = groupsOf(stretch);
    const auto groupOf = [&](Slot slot) { return groups[slot - stretch.firstSlot]; };
    stretch.firstShared = static_cast<Node>(m_layout.nodeCount());
    m_layout.m_sharedNode.resize(levels.slotCount());
    for (Slot slot = stretch.endSlot; slot-- > stretch.firstSlot;) {
        const bool isLast = slot + 1 == stretch.endSlot || groupOf(slot) != groupOf(slot + 1);
        stretch.sharedCount += isLast ? 1 : 0;
        m_layout.m_sharedNode[slot] = stretch.firstShared + stretch.sharedCount - 1;
    }

    const Slot beforeOwn = levels.locate(stretch.end - stretch.ownCount - 1).slot;
    const Node lastOwn = stretch.entry;
    std::vector<Step> steps;
    std::set<std::pair<SetId, Node>> known;
    for (Slot slot = stretch.endSlot; slot-- > stretch.firstSlot;) {
        const auto add = [&](Node next) {
            if (known.emplace(m_graph.canonical(levels.set(slot)), next).second) {
                steps.push_back({slot, next});
            }
        };
        for (const Slot successor : levels.successors(slot)) {
            if (successor < stretch.endSlot) {
                add(m_layout.m_sharedNode[successor]);
            }
        }
        if (slot == beforeOwn) {
            add(lastOwn);
        }
        if (groupOf(slot) == slot) {
            addNode(steps);
            steps.clear();
            known.clear();
        }
    }
    stretch.entry = m_layout.m_sharedNode[levels.locate(stretch.begin).slot];
}

void BoundLayout::Builder::addGrown(std::size_t index)
{
    Stretch &stretch = m_layout.m_stretches[index];
    if (stretch.sharedCount != 0) {
        m_layout.m_firstStep.resize(stretch.firstShared + 1);
        m_layout.m_steps.resize(m_layout.m_firstStep.back());
        stretch.sharedCount = 0;
    }
    stretch.entry = addNode({});
}

}
