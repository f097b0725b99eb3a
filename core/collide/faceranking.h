// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/geometry/box.h"
#include "core/geometry/closestpoint.h"
#include "core/geometry/mesh.h"

namespace romanesco {

/// Which face of a mesh is nearest to a point: of those that it is shown, one by one, and but for rounding. A search
/// through boxes asks it what is worth showing.
///
/// A face ranks by distanceTo(), but no nearer than its own box, then by its number. A box that drops() is farther than
/// the best face, and so is each box inside it, down to those of its faces, since all are computed alike and rounding
/// keeps the order: none of them could have become the best. So what is found does not depend on how faces were put into
/// boxes.
///
/// Squares are of distances in units in which the best is about 1, so that they are numbers at any size. Where the best
/// comes to be far below 1 the units change; squares found before are then too small, so that they drop less.
class FaceRanking
{
public:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    /// mesh must outlive it.
    explicit FaceRanking(const Mesh &mesh)
        : m_mesh(mesh)
    {
    }

    /// Faces at most so far from p count, and such as are farther by less than distances are off; where p moves, of those
    /// ahead. `around` is a box round all that will be shown.
    void begin(const glm::dvec3 &p, double radius, const Box &around, const std::optional<glm::dvec3> &motion);

    /// The squared distance from p to a box, in the ranking's units; infinite where it is no number.
    [[nodiscard]] double squareTo(const Box &box) const;

    /// Whether nothing in a box of that squared distance can be the nearest. It is then counted as looked at.
    [[nodiscard]] bool drops(double square)
    {
        if (square > m_best) {
            m_droppedSquare = std::min({m_droppedSquare, square, std::numeric_limits<double>::max()});
            return true;
        }
        return false;
    }

    void show(std::uint32_t face);

    /// None where no face is within the radius.
    [[nodiscard]] std::uint32_t face() const { return m_face; }
    /// No face that was shown, or is in a box that was dropped, is nearer to p.
    [[nodiscard]] double lower() const;
    [[nodiscard]] std::uint64_t facesShown() const { return m_facesShown; }

private:
    void setUnits(double distance);
    void refineUnits(const Triangle &best);
    [[nodiscard]] double rankOf(const Triangle &triangle, double distance) const;

    const Mesh &m_mesh;
    glm::dvec3 m_p{0.0};
    std::optional<glm::dvec3> m_motion;
    /// A power of two.
    double m_perUnit = 1.0;
    /// The rank of the best face, squared, and its distance; at first those of the radius.
    double m_best = 0.0;
    double m_distance = 0.0;
    std::uint32_t m_face = none;
    std::uint64_t m_facesShown = 0;
    /// Of the faces that were shown, and of boxes before the units changed.
    double m_lower = 0.0;
    double m_droppedSquare = 0.0;
};

}
