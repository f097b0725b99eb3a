// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <vector>

#include "core/formats/fractaldescription.h"
#include "core/geometry/sphere.h"
#include "mapfacts.h"

namespace romanesco {

/// Spheres round what the levels from a position on make of a base mesh, in the frame at that position.
///
/// The last positions have a sphere each, made from the end upwards: what a level makes lies within its maps of the
/// sphere after it. Where maps contract these spheres converge, and all positions further from the end share one with
/// the others of their slot: a sphere proved *invariant* (it holds every map of every sphere that can follow, and the
/// base mesh), hence valid at every greater depth. Where maps do not contract, far positions are bounded about the
/// origin by r ↦ factor·r + offset for each level, composed over repeats by squaring.
class SphereBounds
{
public:
    SphereBounds() = default;

    /// facts stand beside the maps. Cost: some hundred distances for each map, never more than a second or so.
    SphereBounds(const LevelSequence &levels, const std::vector<TransformSet> &sets,
                 const std::vector<std::vector<MapFacts>> &facts, const Sphere &base);

    /// The sphere at a position of the same levels, up to levels.levelCount(). Its radius is infinite where no double
    /// holds it.
    [[nodiscard]] Sphere at(const LevelSequence &levels, Position position) const;
    [[nodiscard]] const Sphere &base() const { return m_tail.front(); }
    [[nodiscard]] std::size_t memoryUse() const;

    /// Bounds how far from the origin levels take points that lie within r of it: factor·r + offset.
    struct Growth {
        double factor = 1.0;
        double offset = 0.0;
    };

private:
    class Builder;
    [[nodiscard]] Growth growthFrom(const LevelSequence &levels, Position position) const;

    /// By the number of levels that remain; the first is the base mesh's.
    std::vector<Sphere> m_tail{Sphere{}};
    /// By slot; empty unless the maps contract.
    std::vector<Sphere> m_invariant;
    /// By slot, and by repeat for one pass of it; empty where there is an invariant or the tail covers all.
    std::vector<Growth> m_slotGrowth;
    std::vector<Growth> m_passGrowth;
};

}
