// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <limits>

#include "core/fractal/statetable.h"
#include "core/geometry/closestpoint.h"
#include "core/geometry/mesh.h"

/// What the ways of going down a graph have in common: LocalFrames and RelativeFrames, between which BranchAndBound does
/// not tell. Lengths are in the units of the frame at hand.
namespace romanesco {

/// A map that is picked on the way down, and the state that follows; or the base mesh, in the frame of the state itself.
struct DescentStep {
    SetId set = 0;
    std::uint32_t map = 0;
    StateId state = 0;

    [[nodiscard]] static constexpr DescentStep toMesh() { return {.map = mesh}; }
    [[nodiscard]] bool isToMesh() const { return map == mesh; }

private:
    static constexpr std::uint32_t mesh = std::numeric_limits<std::uint32_t>::max();
};

/// A coordinate along which no two maps of a text are likely to be alike.
[[nodiscard]] inline double placeOf(const glm::dvec3 &point)
{
    return 0.618 * point.x + 0.285 * point.y + 0.733 * point.z;
}

/// What a copy of the base mesh has to offer.
struct LeafHit {
    /// None where no face is within the limit.
    std::uint32_t face = Mesh::none;
    Triangle triangle{};
    /// Off by what rounding does to the coordinates, as seen from p; but within the limit if the true one is.
    double distance = std::numeric_limits<double>::infinity();
    /// No face of the copy is nearer.
    double lower = std::numeric_limits<double>::infinity();
    std::uint64_t faceTests = 0;
};

}
