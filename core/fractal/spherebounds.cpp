// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "spherebounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

using Growth = SphereBounds::Growth;
using Slot = LevelSequence::Slot;

/// A position has a sphere of its own until the levels after it have shrunk the rest to this part of it.
constexpr double sharedFrom = 1.0 / 128.0;
/// Never more spheres than these.
constexpr Position longestContractingTail = 4'096;
constexpr Position longestTail = 65'536;
/// Nor longer than a second or so of work: maps looked at, each some hundred distances.
constexpr std::size_t mostMaps = 1'000'000;

Growth composed(const Growth &outer, const Growth &inner)
{
    return {outer.factor * inner.factor, outer.factor * inner.offset + outer.offset};
}

Growth power(Growth growth, std::uint64_t exponent)
{
    Growth result;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) {
            result = composed(result, growth);
        }
        growth = composed(growth, growth);
    }
    return result;
}

double reachOf(const Sphere &sphere)
{
    return glm::length(sphere.centre) + sphere.radius;
}

}

class SphereBounds::Builder
{
public:
    Builder(const LevelSequence &levels, const std::vector<TransformSet> &sets,
            const std::vector<std::vector<MapFacts>> &facts, const Sphere &base)
        : m_levels(levels)
        , m_sets(sets)
        , m_facts(facts)
        , m_base(base)
    {
    }

    SphereBounds build()
    {
        m_bounds.m_tail.front() = m_base;
        const Position count = m_levels.levelCount();
        findLargestNorms();
        const Position own = contractingTail();
        const bool hasInvariant = own < std::min(count, longestContractingTail) && findInvariant();
        buildTail(hasInvariant ? own : std::min(count, longestTail));
        if (!hasInvariant) {
            m_bounds.m_invariant.clear();
            if (count >= m_bounds.m_tail.size()) {
                buildGrowth();
            }
        }
        return std::move(m_bounds);
    }

private:
    const TransformSet &setAt(Slot slot) const { return m_sets[m_levels.set(slot)]; }
    const std::vector<MapFacts> &factsAt(Slot slot) const { return m_facts[m_levels.set(slot)]; }

    void findLargestNorms()
    {
        for (Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
            const std::vector<MapFacts> &facts = factsAt(slot);
            m_largestNorm.push_back(facts.empty() ? 1.0 : std::ranges::max(facts, {}, &MapFacts::norm).norm);
            m_mapCount += facts.size();
        }
    }

    /// How many levels at the end keep spheres of their own.
    Position contractingTail() const
    {
        const Position count = m_levels.levelCount();
        double size = 1.0;
        Position remaining = 0;
        while (remaining < count && remaining < longestContractingTail && size > sharedFrom) {
            ++remaining;
            size *= m_largestNorm[m_levels.locate(count - remaining).slot];
        }
        return remaining;
    }

    /// A sphere round the maps of a level applied to the sphere after it.
    Sphere oneLevelUp(Slot slot, const Sphere &next)
    {
        const TransformSet &set = setAt(slot);
        const std::vector<MapFacts> &facts = factsAt(slot);
        m_spheres.clear();
        for (std::size_t i = 0; i < set.maps.size(); ++i) {
            m_spheres.push_back(transformed(set.maps[i], facts[i].norm, next));
        }
        if (set.holdsIdentity) {
            m_spheres.push_back(next);
        }
        return m_spheres.size() == 1 ? m_spheres.front() : enclosingSphere(m_spheres);
    }

    void buildTail(Position length)
    {
        const Position count = m_levels.levelCount();
        std::size_t looked = 0;
        for (Position remaining = 1; remaining <= length && looked <= mostMaps; ++remaining) {
            const Slot slot = m_levels.locate(count - remaining).slot;
            m_bounds.m_tail.push_back(oneLevelUp(slot, m_bounds.m_tail.back()));
            looked += factsAt(slot).size();
        }
    }

    // ---- The invariant

    /// Slots that can reach one another by passing levels over are bounded alike: all slots of a repeat in which every
    /// level holds `#`. The first slot of the outermost such repeat stands for them.
    void groupSlots()
    {
        m_group.resize(m_levels.slotCount());
        for (Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
            m_group[slot] = slot;
        }
        const std::vector<LevelSequence::Repeat> &repeats = m_levels.repeats();
        for (std::size_t i = repeats.size(); i-- > 1;) { // inner repeats first, so that the outermost has its say last
            Slot slot = repeats[i].firstSlot;
            while (slot < repeats[i].endSlot && setAt(slot).holdsIdentity) {
                ++slot;
            }
            if (repeats[i].count > 1 && slot == repeats[i].endSlot) {
                std::fill(m_group.begin() + repeats[i].firstSlot, m_group.begin() + slot, repeats[i].firstSlot);
            }
        }
    }

    const Sphere &sphereAt(Slot slot) const
    {
        return slot == m_levels.slotCount() ? m_base : m_bounds.m_invariant[m_group[slot]];
    }

    /// What the sphere of a group must hold: for each of its slots and what may follow it, the maps of the next sphere,
    /// and that sphere itself where the level may be passed over.
    const std::vector<Sphere> &contentOf(Slot first)
    {
        m_spheres.clear();
        for (Slot slot = first; slot < m_levels.slotCount() && m_group[slot] == first; ++slot) {
            const TransformSet &set = setAt(slot);
            for (const Slot successor : m_levels.successors(slot)) {
                const Sphere &next = sphereAt(successor);
                for (std::size_t i = 0; i < set.maps.size(); ++i) {
                    m_spheres.push_back(transformed(set.maps[i], factsAt(slot)[i].norm, next));
                }
                const bool isOther = successor == m_levels.slotCount() || m_group[successor] != first;
                if (set.holdsIdentity && isOther) {
                    m_spheres.push_back(next);
                }
            }
        }
        return m_spheres;
    }

    /// Calls visit(slot) for the slot that stands for each group, the last first.
    template<typename Visit>
    void forEachGroup(Visit visit)
    {
        for (Slot slot = m_levels.slotCount(); slot-- > 0;) {
            if (m_group[slot] == slot) {
                visit(slot);
            }
        }
    }

    /// Centres by iterating the content until they settle; radii for those centres by iterating the largest reach; then
    /// a margin, until each holds its content as it stands.
    bool findInvariant()
    {
        groupSlots();
        std::vector<Sphere> &spheres = m_bounds.m_invariant;
        spheres.assign(m_levels.slotCount(), m_base);
        const int rounds = static_cast<int>(std::clamp<std::size_t>(mostMaps / (m_mapCount + 1), 4, 400));
        for (int round = 0; round < rounds; ++round) {
            double change = 0.0;
            forEachGroup([&](Slot slot) {
                const Sphere next = enclosingSphere(contentOf(slot));
                const double moved =
                    glm::distance(next.centre, spheres[slot].centre) + std::abs(next.radius - spheres[slot].radius);
                change = std::max(change, moved / next.radius);
                spheres[slot] = next;
            });
            if (!std::isfinite(change)) {
                return false;
            }
            if (change <= 1e-3) {
                break;
            }
        }
        for (int round = 0; round < rounds; ++round) {
            double change = 0.0;
            forEachGroup([&](Slot slot) {
                const double radius = enclosingRadius(spheres[slot].centre, contentOf(slot));
                change = std::max(change, std::abs(radius - spheres[slot].radius) / radius);
                spheres[slot].radius = radius;
            });
            if (!(change > 1e-6)) {
                break;
            }
        }
        for (double margin = 1e-5; margin < 2.0; margin *= 4.0) {
            for (Sphere &sphere : spheres) {
                sphere.radius *= 1.0 + margin;
            }
            if (settle()) {
                for (Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
                    spheres[slot] = spheres[m_group[slot]];
                }
                return true;
            }
        }
        return false;
    }

    /// Enlarges what does not hold its content until all do. What `#` passes on unchanged leaves no room for rounding, so
    /// that a margin on all alike is not enough; what maps pass on has shrunk, so that this ends soon.
    bool settle()
    {
        constexpr int rounds = 64;
        for (int round = 0; round < rounds; ++round) {
            bool isSettled = true;
            bool isFinite = true;
            forEachGroup([&](Slot slot) {
                Sphere &sphere = m_bounds.m_invariant[slot];
                const double needed = enclosingRadius(sphere.centre, contentOf(slot));
                isFinite = isFinite && std::isfinite(needed);
                if (needed > sphere.radius) {
                    sphere.radius = needed;
                    isSettled = false;
                }
            });
            if (isSettled || !isFinite) {
                return isFinite;
            }
        }
        return false;
    }

    // ---- Growth

    void buildGrowth()
    {
        for (Slot slot = 0; slot < m_levels.slotCount(); ++slot) {
            Growth growth{setAt(slot).holdsIdentity ? 1.0 : 0.0, 0.0};
            for (std::size_t i = 0; i < setAt(slot).maps.size(); ++i) {
                growth.factor = std::max(growth.factor, factsAt(slot)[i].norm);
                growth.offset = std::max(growth.offset, glm::length(setAt(slot).maps[i].translation));
            }
            m_bounds.m_slotGrowth.push_back(growth);
        }

        // Inner repeats have greater numbers than those round them.
        const std::vector<LevelSequence::Repeat> &repeats = m_levels.repeats();
        m_bounds.m_passGrowth.resize(repeats.size());
        for (std::size_t i = repeats.size(); i-- > 0;) {
            Growth growth;
            Slot slot = repeats[i].firstSlot;
            for (const std::uint32_t inner : repeats[i].inner) {
                for (; slot < repeats[inner].firstSlot; ++slot) {
                    growth = composed(growth, m_bounds.m_slotGrowth[slot]);
                }
                growth = composed(growth, power(m_bounds.m_passGrowth[inner], repeats[inner].count));
                slot = repeats[inner].endSlot;
            }
            for (; slot < repeats[i].endSlot; ++slot) {
                growth = composed(growth, m_bounds.m_slotGrowth[slot]);
            }
            m_bounds.m_passGrowth[i] = growth;
        }
    }

    const LevelSequence &m_levels;
    const std::vector<TransformSet> &m_sets;
    const std::vector<std::vector<MapFacts>> &m_facts;
    const Sphere m_base;
    SphereBounds m_bounds;
    std::vector<double> m_largestNorm;
    std::size_t m_mapCount = 0;
    std::vector<Slot> m_group;
    std::vector<Sphere> m_spheres;
};

SphereBounds::SphereBounds(const LevelSequence &levels, const std::vector<TransformSet> &sets,
                           const std::vector<std::vector<MapFacts>> &facts, const Sphere &base)
    : SphereBounds(Builder(levels, sets, facts, base).build())
{
}

Sphere SphereBounds::at(const LevelSequence &levels, Position position) const
{
    const Position remaining = levels.levelCount() - position;
    if (remaining < m_tail.size()) {
        return m_tail[remaining];
    }
    if (!m_invariant.empty()) {
        return m_invariant[levels.locate(position).slot];
    }
    const Growth growth = growthFrom(levels, position);
    const double radius = growth.factor * reachOf(base()) + growth.offset;
    return {glm::dvec3(0.0), std::isnan(radius) ? std::numeric_limits<double>::infinity() : radius * (1.0 + 1e-9)};
}

/// Walks from a position to the end: slots singly, inner repeats and the passes left of a repeat by powers.
Growth SphereBounds::growthFrom(const LevelSequence &levels, Position position) const
{
    Growth growth;
    while (position < levels.levelCount()) {
        const auto [slot, index, end] = levels.locate(position);
        const LevelSequence::Repeat &repeat = levels.repeats()[index];
        const Position left = end - position;
        if (index != 0 && slot == repeat.firstSlot && left % repeat.passLength == 0) {
            growth = composed(growth, power(m_passGrowth[index], left / repeat.passLength));
            position = end;
        } else {
            growth = composed(growth, m_slotGrowth[slot]);
            ++position;
        }
    }
    return growth;
}

std::size_t SphereBounds::memoryUse() const
{
    return (m_tail.capacity() + m_invariant.capacity()) * sizeof(Sphere)
        + (m_slotGrowth.capacity() + m_passGrowth.capacity()) * sizeof(Growth);
}

}
