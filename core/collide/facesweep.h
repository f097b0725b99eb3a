// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <limits>

#include "core/geometry/affinemap.h"
#include "core/geometry/mesh.h"
#include "core/geometry/movingsphere.h"
#include "facetree.h"

namespace romanesco {

/// The face of a mesh that a moving sphere touches first.
struct SweptFace {
    /// None where none is touched within the limit.
    std::uint32_t face = Mesh::none;
    double way = std::numeric_limits<double>::infinity();
    /// Seen from the sphere's start.
    Triangle triangle{};
    /// No face is touched before.
    double lower = std::numeric_limits<double>::infinity();
    std::uint64_t faceTests = 0;
    std::uint64_t nodeVisits = 0;
};

/// Up to which way something may be touched that counts beside what is touched at a way: nothing is before the start.
[[nodiscard]] double earlierThan(double way, double slack);

/// Goes down a tree of a mesh's faces, to what may be touched first. It never allocates. One thread uses it.
class FaceSweep
{
public:
    /// Both must outlive it; the tree is of that mesh.
    FaceSweep(const Mesh &mesh, const FaceTree &tree)
        : m_mesh(mesh)
        , m_tree(tree)
    {
    }

    /// Of the mesh as it stands, for a sphere that starts at a point. Faces that are touched on a way up to the limit count;
    /// such as are touched later than another, or earlier by no more than `slack`, may be passed over.
    void sweep(const glm::dvec3 &start, const MovingSphere &sphere, double limit, double slack, SweptFace &found);
    /// The same of what a map makes of the mesh, seen from the start. Two or three times the cost.
    void sweep(const AffineMap &map, const MovingSphere &sphere, double limit, double slack, SweptFace &found);

private:
    /// A node that is touched there at the earliest.
    struct Waiting {
        double way;
        std::uint32_t node;
    };
    template<typename View>
    void search(const View &view, const MovingSphere &sphere, double limit, double slack, SweptFace &found);

    const Mesh &m_mesh;
    const FaceTree &m_tree;
    std::array<Waiting, FaceTree::mostDepth> m_waiting;
};

}
