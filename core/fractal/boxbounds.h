// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/mesh.h"
#include "fractalgraph.h"

namespace romanesco {

/// Axis-aligned boxes round what the levels from a position on make of a mesh, in the frame at that position: tight, where
/// the spheres of a graph are round.
///
/// They are kept by the nodes of the graph's BoundLayout, from the end upwards, and found by searching how far each
/// reaches along the axes (SupportSearch). A box that positions share is proved for every depth, since it is found from
/// spheres and boxes that are. In stretches that grow, intervals are followed for each axis, over repeats by squaring.
///
/// Immutable; any number of threads may read it. It belongs to the graph that it was made for.
class BoxBounds
{
public:
    BoxBounds() = default;

    /// The mesh is the one whose sphere the graph was made with. Cost: some milliseconds; never more than some ten million
    /// maps are looked at.
    BoxBounds(const FractalGraph &graph, const Mesh &mesh);

    /// Up to levels().levelCount(). Of nothing where no face is; infinite where no double holds it.
    [[nodiscard]] Box at(const FractalGraph &graph, Position position) const;

    /// By node of the graph's layout.
    [[nodiscard]] std::span<const Box> ofNodes() const { return m_boxes; }

    [[nodiscard]] std::size_t memoryUse() const { return m_boxes.capacity() * sizeof(Box); }

private:
    class Builder;

    std::vector<Box> m_boxes{Box::ofNothing()};
};

}
