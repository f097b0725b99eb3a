// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/box.h"
#include "core/geometry/closestpoint.h"
#include "core/geometry/mesh.h"
#include "descent.h"
#include "facelanes.h"
#include "facesweep.h"

namespace romanesco {

/// The faces of a small mesh, all looked at together, which costs less than to go down a tree of them. Immutable.
class LeafFaces
{
public:
    /// Of larger meshes it has none.
    static constexpr std::size_t most = 32;

    /// The mesh must outlive it.
    explicit LeafFaces(const Mesh &mesh);

    [[nodiscard]] bool isEmpty() const { return m_corners.empty(); }
    [[nodiscard]] std::size_t memoryUse() const;

    /// The face that is nearest to p, if it is within a limit; where p moves, of those ahead.
    void measure(const glm::dvec3 &p, double limit, const std::optional<glm::dvec3> &motion, LeafHit &hit) const;
    /// The same for the origin, of what a map makes of the mesh. Twice the cost.
    void measure(const AffineMap &map, double limit, const std::optional<glm::dvec3> &motion, LeafHit &hit) const;

    /// The face that a sphere touches first: as FaceSweep::sweep(), for one that touches nothing before a way.
    void sweep(const glm::dvec3 &start, const MovingSphere &sphere, double from, double limit, double slack,
               SweptFace &found) const;
    void sweep(const AffineMap &map, const MovingSphere &sphere, double from, double limit, double slack,
               SweptFace &found) const;

private:
    /// No coordinate of a corner, seen from p, is larger.
    [[nodiscard]] double reachFrom(const glm::dvec3 &p) const;
    [[nodiscard]] double reachOf(const AffineMap &map) const;
    [[nodiscard]] Triangle placedTriangle(const AffineMap &map, std::size_t face) const;

    const Mesh &m_mesh;
    Box m_box;
    std::vector<CornerLanes> m_corners;
    std::vector<FaceLanes> m_faces;
};

}
