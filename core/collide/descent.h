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

/// A map that was picked on the way down, and the state that follows.
struct DescentStep {
    SetId set = 0;
    std::uint32_t map = 0;
    StateId state = 0;
};

/// What a copy of the base mesh has to offer.
struct LeafHit {
    /// None where no face is within the limit.
    std::uint32_t face = Mesh::none;
    ClosestPoint nearest;
    Triangle triangle{};
    /// No face of the copy is nearer.
    double lower = std::numeric_limits<double>::infinity();
    std::uint64_t faceTests = 0;
};

}
