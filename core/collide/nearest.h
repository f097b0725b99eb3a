// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "collider.h"
#include "core/geometry/affinemap.h"
#include "core/geometry/closestpoint.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// The nearest of the faces that were looked at so far, one by one, of copies of a mesh.
class NearestFace
{
public:
    /// The mesh and the query must outlive it.
    NearestFace(const Mesh &mesh, const Query &query)
        : m_mesh(mesh)
        , m_query(query)
    {
    }

    /// Looks at all faces of a copy; does those count that p does not come nearer to? Whether the nearest so far is one of
    /// them.
    enum class Counted { All, Ahead };
    bool consider(const AffineMap &modelFromBase, Counted counted, std::vector<glm::dvec3> &scratch);

    /// Forgets all but the number of tests.
    void restart();

    /// Infinite distances before the first face.
    [[nodiscard]] const ClosestPoint &nearest() const { return m_nearest; }
    [[nodiscard]] std::uint32_t face() const { return m_face; }
    [[nodiscard]] const Triangle &triangle() const { return m_triangle; }
    [[nodiscard]] std::uint64_t faceTests() const { return m_faceTests; }
    /// What is proved of all faces together.
    [[nodiscard]] double lower() const { return m_lower; }

private:
    static constexpr ClosestPoint nothing{glm::dvec3(0.0), std::numeric_limits<double>::infinity(),
                                          std::numeric_limits<double>::infinity()};

    const Mesh &m_mesh;
    const Query &m_query;
    ClosestPoint m_nearest = nothing;
    double m_lower = nothing.lower;
    Triangle m_triangle{};
    std::uint32_t m_face = 0;
    std::uint64_t m_faceTests = 0;
};

[[nodiscard]] inline Triangle triangleOf(const Mesh &mesh, std::uint32_t face)
{
    const Mesh::Face &corners = mesh.faces[face];
    return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

/// Makes a Hit or a Touch say that nothing was found, for nothing.
template<typename Answer>
void clear(Answer &answer)
{
    Address address = std::move(answer.address); // for its memory
    address.clear();
    answer = {};
    answer.address = std::move(address);
}

/// The direction of a contact with a point of a triangle, as Hit has it.
[[nodiscard]] glm::dvec3 contactDirection(const glm::dvec3 &point, const Triangle &triangle, const glm::dvec3 &p,
                                          const std::optional<glm::dvec3> &motion);

/// Whether p comes nearer to that point, or does not move.
[[nodiscard]] bool isAhead(const glm::dvec3 &point, const Triangle &triangle, const glm::dvec3 &p,
                           const std::optional<glm::dvec3> &motion);

/// Puts in the nearest point of a face, with its distance and direction.
void place(Hit &hit, const ClosestPoint &nearest, const Triangle &triangle, const glm::dvec3 &p,
           const std::optional<glm::dvec3> &motion);

/// What the faces come to for a query, but for the address. lower is that of the faces where the promise is Exact, else 0.
void report(const NearestFace &nearest, const Query &query, Promise promise, Hit &hit);

}
