// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <vector>

#include <boost/container/small_vector.hpp>

#include "core/formats/fractaldescription.h"
#include "core/geometry/sphere.h"
#include "mapfacts.h"
#include "spherebounds.h"

namespace romanesco {

/// A fractal as a graph-directed iterated function system (Mauldin and Williams 1988): what drawing, colliding and
/// counting read. It never lists instances: it takes kilobytes at any depth and is built in milliseconds.
///
/// A *word* is a sequence of picks, one map from each of some levels, outermost first. A level that holds `#` may be
/// passed over. The same picks can often be placed in several ways; only the *canonical* placing counts, each pick at
/// the earliest level that has its set, so that each sequence of picks occurs once.
///
/// Immutable once built; any number of threads may read it.
class FractalGraph
{
public:
    /// base is a sphere round the base mesh. The error is a transformation's place in the text: the fractal grows
    /// beyond what a double holds, by that transformation most of all (or the mesh's place, where that is to blame).
    [[nodiscard]] static std::expected<FractalGraph, SourceRange> build(const FractalDescription &description,
                                                                        const Sphere &base);

    /// A single instance of a base mesh.
    [[nodiscard]] static FractalGraph ofMesh(const Sphere &base);

    [[nodiscard]] const LevelSequence &levels() const { return m_levels; }
    [[nodiscard]] std::size_t setCount() const { return m_sets.size(); }
    /// Empty where no level has the set.
    [[nodiscard]] const TransformSet &set(SetId id) const { return m_sets[id]; }
    [[nodiscard]] const TransformSet &setAt(LevelSequence::Slot slot) const { return m_sets[m_levels.set(slot)]; }

    /// Beside the maps of a set.
    [[nodiscard]] const std::vector<MapFacts> &facts(SetId id) const { return m_facts[id]; }

    /// The first set that holds the same maps, in whatever order, and `#` or not alike.
    [[nodiscard]] SetId canonical(SetId id) const { return m_canonical[id]; }

    /// Numbers for the maps of a set, equal where and only where the maps are.
    [[nodiscard]] const std::vector<std::uint32_t> &mapClasses(SetId id) const { return m_mapClasses[id]; }
    [[nodiscard]] std::uint32_t mapClassCount() const { return m_mapClassCount; }

    /// Whether a map occurs in two sets that are not the same.
    [[nodiscard]] bool setsShareMaps() const { return m_setsShareMaps; }

    /// The levels that the next pick may be made from: the one at a position and, while those passed over hold `#`, the
    /// ones after it, of each distinct set the first.
    struct Reach {
        struct Level {
            Position position;
            LevelSequence::Slot slot;
        };
        boost::container::small_vector<Level, 2> levels;
        /// All levels to the end may be passed over: no pick is needed.
        bool reachesEnd = false;
        /// The last position that is reached by passing levels over; levelCount() where reachesEnd.
        Position last = 0;
    };
    /// Cost linear in the slots passed, however deep the fractal; where nothing but `#` levels are left, it ends with
    /// the last set that is new.
    [[nodiscard]] Reach reach(Position position) const;

    /// A sphere round all that the levels from a position on make of the base mesh, in the frame at that position.
    /// From some number of remaining levels on all positions of a slot share one sphere.
    [[nodiscard]] Sphere bound(Position position) const { return m_bounds.at(m_levels, position); }
    [[nodiscard]] const Sphere &base() const { return m_bounds.base(); }
    [[nodiscard]] const SphereBounds &bounds() const { return m_bounds; }
    [[nodiscard]] const BoundLayout &layout() const { return m_bounds.layout(); }

    /// Bytes held, for the record.
    [[nodiscard]] std::size_t memoryUse() const;

private:
    FractalGraph() = default;
    void dropUnusedSets();
    void classifyMaps();
    void findEqualSets();
    void findLastFixedLevel();
    [[nodiscard]] std::optional<SourceRange> strongestGrowth() const;

    LevelSequence m_levels;
    std::vector<TransformSet> m_sets;
    std::vector<std::vector<MapFacts>> m_facts;
    std::vector<SetId> m_canonical;
    std::vector<std::vector<std::uint32_t>> m_mapClasses;
    std::uint32_t m_mapClassCount = 0;
    bool m_setsShareMaps = false;
    std::size_t m_distinctSetCount = 0;
    /// From here on every level holds `#`.
    Position m_passableFrom = 0;
    SphereBounds m_bounds;
};

}
