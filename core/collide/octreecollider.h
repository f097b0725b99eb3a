// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <expected>
#include <stop_token>
#include <string>
#include <vector>

#include "collider.h"
#include "core/fractal/fractalgraph.h"
#include "core/geometry/box.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// The dissertation's alternative to its collider for fractals (5.4), as it is: an octree over the vertices of the
/// surface written out, of depth 3·log8(faces), rounded. From the box round all of them a query goes on in the nearest of
/// the octants that hold vertices, and what it finds is a point of the box that it ends with: a nearer point of the
/// surface may be elsewhere, and the box may be no part of it. Promise::None, no face, no address. Kept for comparison.
///
/// Boxes are hollow and cost 12 face tests each, since there they are asked as the 12 triangles of their walls. (Its
/// figure 18 has 8·12·3·log8(faces), as if all octants held something.) Of equally near octants the first is taken, x
/// changing first, then y, then z.
///
/// A sweep, of which the dissertation has none, goes on in the octant whose walls the sphere touches first, or, where it
/// touches none, in the one that is nearest to its start.
///
/// Nodes are kept more tightly than there: their boxes are found on the way down, and where all vertices are one point
/// the octants below follow from it. What is found and what it costs are not changed by that.
class OctreeCollider final : public Collider
{
public:
    static constexpr std::uint64_t mostFaces = 10'000'000;

    /// How it was built.
    struct Build {
        std::uint64_t faces = 0;
        /// Of all copies, those that faces use.
        std::uint64_t vertices = 0;
        int depth = 0;
        std::uint64_t nodes = 0;
        /// Times that a vertex was put into an octant.
        std::uint64_t placements = 0;
    };

    [[nodiscard]] static int depthFor(std::uint64_t faces);

    /// The graph is of that mesh; neither is needed afterwards. The error is a sentence: more than mostFaces faces, a
    /// vertex that is not finite or above 1e300, or cancelled. Cost: about half a microsecond a vertex, and 24 bytes while
    /// it is made.
    [[nodiscard]] static std::expected<OctreeCollider, std::string> create(const FractalGraph &graph, const Mesh &mesh,
                                                                           const std::stop_token &stop = {});

    [[nodiscard]] std::unique_ptr<Search> search() const override;
    [[nodiscard]] std::size_t memoryUse() const override;
    [[nodiscard]] const Build &build() const { return m_build; }

private:
    class Builder;
    class Descent;

    struct Node {
        /// The first of its children, in order of their octants; or, where it is not divided, the point.
        std::uint32_t first = 0;
        /// A bit for each octant with vertices; 0 where the node is not divided.
        std::uint8_t octants = 0;
    };

    OctreeCollider() = default;

    Build m_build;
    Box m_box;
    /// The root first; none without vertices.
    std::vector<Node> m_nodes;
    std::vector<glm::dvec3> m_points;
};

}
