// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "shrinkingball.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace romanesco::bench {

namespace {

constexpr std::size_t ofExact = 1;
/// Near the one of which all can be seen.
constexpr glm::dvec3 picturedAt{-0.737, 1.512, 1.140};
/// From where it is thrown, in radii, and how fast.
constexpr glm::dvec3 thrownFrom{-0.3, 0.8, 0.6};
constexpr double speedInRadii = 4.0;

/// For a ball that falls from where it rests.
Ways waysFrom(const Ball &resting, const Ball &fallen)
{
    return {.from = resting.position,
            .to = fallen.position,
            .highest = resting.position.y + 0.01 * resting.radius,
            .margin = 1.5 * resting.radius};
}

}

const std::array<NamedManner, 4> &manners()
{
    static const std::array<NamedManner, 4> all{{
        {"exact, our steps", {.isAsInDissertation = false, .rate = 240.0}},
        {"exact", {}},
        {"greedy", {.collider = ColliderKind::Greedy}},
        {"octree", {.collider = ColliderKind::Octree}},
    }};
    return all;
}

ShrinkingTrial shrinkingTrial(const ShrinkingGround &ground)
{
    ShrinkingTrial trial;
    const std::vector<Ball> balls = ballsThatHit(ground, ShrinkingTrial::radius, ShrinkingTrial::dropCount);
    trial.resting = restingBalls(ground, ShrinkingTrial::radius, ShrinkingTrial::placeCount);
    for (std::size_t i = 0; i < manners().size(); ++i) {
        for (const Ball &ball : balls) {
            trial.contacts[i].push_back(firstContact(ground, ball, manners()[i].manner));
        }
        for (const Ball &ball : trial.resting) {
            trial.shrinking[i].push_back(shrunk(ground, ball, manners()[i].manner));
        }
    }
    for (std::size_t i = 0; i < trial.resting.size(); ++i) {
        const std::optional<Ball> &fallen = trial.shrinking[ofExact][i].fallen;
        const Collider &exact = *ground.exact.collider;
        trial.gaps.push_back(fallen ? widestWayTo(exact, waysFrom(trial.resting[i], *fallen)) : Neck());
        trial.waysDown.push_back(fallen ? widestWayDown(exact, waysFrom(trial.resting[i], *fallen)) : Neck());
    }
    return trial;
}

PicturedBall picturedBall(const ShrinkingGround &ground, const ShrinkingTrial &trial)
{
    const auto nearest = std::ranges::min_element(
        trial.resting, {}, [](const Ball &ball) { return glm::distance(ball.position, picturedAt); });
    const auto pictured = static_cast<std::size_t>(nearest - trial.resting.begin());
    PicturedBall made{.resting = trial.resting[pictured], .gap = trial.gaps[pictured], .contacts = {}, .shrinking = {}};
    Ball thrown = made.resting;
    thrown.position += thrown.radius * thrownFrom;
    thrown.velocity = -speedInRadii * thrown.radius * thrownFrom / glm::length(thrownFrom);
    for (std::size_t i = 0; i < made.contacts.size(); ++i) {
        made.contacts[i] = firstContact(ground, thrown, manners()[ofExact + i].manner);
        made.shrinking[i] = trial.shrinking[ofExact + i][pictured];
    }
    return made;
}

}
