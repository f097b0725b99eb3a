// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <vector>

#include "boundlayout.h"
#include "core/geometry/sphere.h"
#include "levelruns.h"

namespace romanesco {

/// Spheres round what the levels from a position on make of a base mesh, in the frame at that position.
///
/// They are kept by the nodes of a BoundLayout and made from the end upwards: what a level makes lies within its maps of
/// the sphere after it. Nodes that positions share get spheres proved *invariant*: each holds every map of every sphere
/// that can follow, hence is valid at any depth. In stretches that grow, positions are bounded about the origin by
/// r ↦ factor·r + offset for each level, composed over repeats by squaring.
class SphereBounds
{
public:
    SphereBounds() = default;

    /// Of a graph whose levels, sets and facts are there. Cost: some hundred distances for each map, never more than a
    /// second or so.
    SphereBounds(const FractalGraph &graph, const Sphere &base);

    /// The sphere at a position of the same levels, up to levels.levelCount(). Its radius is infinite where no double
    /// holds it.
    [[nodiscard]] Sphere at(const LevelSequence &levels, Position position) const;
    [[nodiscard]] const Sphere &ofNode(BoundLayout::Node node) const { return m_spheres[node]; }
    [[nodiscard]] const Sphere &base() const { return m_spheres[BoundLayout::end]; }
    [[nodiscard]] const BoundLayout &layout() const { return m_layout; }
    [[nodiscard]] std::size_t memoryUse() const;

    /// Bounds how far from the origin levels take points that lie within r of it: factor·r + offset.
    struct Growth {
        double factor = 1.0;
        double offset = 0.0;
    };

private:
    class Builder;
    [[nodiscard]] Growth growthOf(const LevelRun &run) const;
    [[nodiscard]] Sphere grown(const LevelSequence &levels, Position position,
                               const BoundLayout::Stretch &stretch) const;

    BoundLayout m_layout;
    /// By node.
    std::vector<Sphere> m_spheres{Sphere{}};
    /// By slot, and by repeat for one pass of it; empty unless a stretch grows.
    std::vector<Growth> m_slotGrowth;
    std::vector<Growth> m_passGrowth;
};

}
