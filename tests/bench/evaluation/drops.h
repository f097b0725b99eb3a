// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/physics/ball.h"
#include "shrinkingground.h"

namespace romanesco::bench {

/// How balls are stepped, and what they ask.
struct Manner {
    ColliderKind collider = ColliderKind::Exact;
    bool isAsInDissertation = true;
    /// Steps a second.
    double rate = 480.0;
};

/// How far the surface is from a ball, by the exact collider, in radii; negative where it reaches in.
[[nodiscard]] double gapOf(const ShrinkingGround &ground, const Ball &ball);

/// So many balls at rest above the ground, without any bounce, that do touch it when they fall, by the exact collider. The
/// same each time.
[[nodiscard]] std::vector<Ball> ballsThatHit(const ShrinkingGround &ground, double radius, std::size_t count);

/// A ball that falls until a collider answers.
struct FirstContact {
    /// With its position after the step in which it was first held or thrown back; none where it came through.
    std::optional<Ball> ball = {};
    /// Then, see gapOf().
    double gap = 0.0;
    /// The most that the surface has reached in until then, or until it was through; in radii, 0 for not at all.
    double depth = 0.0;
};
[[nodiscard]] FirstContact firstContact(const ShrinkingGround &ground, const Ball &ball, const Manner &manner);

/// So many balls as they rest on the ground, by the exact collider: where our own steps let them lie, and the
/// dissertation's too, each farther than a tenth of the radius from the others. The same each time.
[[nodiscard]] std::vector<Ball> restingBalls(const ShrinkingGround &ground, double radius, std::size_t count);

/// A ball, without any bounce, that starts where another rests, or above that, where its own collider has room for it; has a
/// second to come to rest, and then shrinks to a tenth within five.
struct Shrinking {
    static constexpr double settleSeconds = 1.0;
    static constexpr double shrinkSeconds = 5.0;
    static constexpr double leastShare = 0.1;

    /// After that second, if it is no farther from there than its radius.
    std::optional<Ball> rest = {};
    /// When it was last held before it fell, by more than its radius without a touch or two radii below its start, and when
    /// it had; with rest or without. None where it did not fall, or rests elsewhere.
    std::optional<Ball> held = {};
    std::optional<Ball> fallen = {};
};
[[nodiscard]] Shrinking shrunk(const ShrinkingGround &ground, const Ball &resting, const Manner &manner);

}
