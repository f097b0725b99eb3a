// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <array>
#include <string>
#include <vector>

#include "drops.h"
#include "neck.h"

namespace romanesco::bench {

/// A way to step a ball, for people.
struct NamedManner {
    std::string name;
    Manner manner;
};

/// The exact collider by our own steps, then exact, greedy and octree by the dissertation's.
[[nodiscard]] const std::array<NamedManner, 4> &manners();

/// 5.5 of the dissertation once more: balls that fall and shrink on a ground, by each manner.
struct ShrinkingTrial {
    static constexpr double radius = 0.02 * ShrinkingGround::size;
    static constexpr std::size_t dropCount = 200;
    static constexpr std::size_t placeCount = 60;

    /// By manner.
    std::array<std::vector<FirstContact>, 4> contacts;
    /// Where balls rest, and what becomes of them there, by manner, beside them.
    std::vector<Ball> resting;
    std::array<std::vector<Shrinking>, 4> shrinking;
    /// Beside them, of what the ball of the exact collider does by the dissertation's steps: the gap that it falls through,
    /// the widest way to where it has fallen; and the widest of all ways as far down. 0 where it does not fall.
    std::vector<Neck> gaps;
    std::vector<Neck> waysDown;
};

/// Costs some minutes. The same each time.
[[nodiscard]] ShrinkingTrial shrinkingTrial(const ShrinkingGround &ground);

/// One ball of all that, as it is seen in figure 19: it is thrown at the place where it rests, settles and shrinks.
struct PicturedBall {
    Ball resting;
    Neck gap;
    /// Exact, greedy and octree, by the dissertation's steps.
    std::array<FirstContact, 3> contacts;
    std::array<Shrinking, 3> shrinking;
};
[[nodiscard]] PicturedBall picturedBall(const ShrinkingGround &ground, const ShrinkingTrial &trial);

}
