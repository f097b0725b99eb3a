// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballpairs.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Beside the radii: what touches but for rounding, and is pushed out of a surface.
constexpr double margin = 1e-3;

/// Where a ball can be within a time.
struct Reach {
    double least;
    double radius;
    std::size_t ball;
};

std::size_t rootOf(std::vector<std::size_t> &parents, std::size_t ball)
{
    while (parents[ball] != ball) {
        ball = parents[ball] = parents[parents[ball]];
    }
    return ball;
}

}

std::vector<BallPair> nearPairs(std::span<const BallState> balls, const Laws &laws, double time)
{
    const double fall = 0.5 * glm::length(laws.gravity) * time * time;
    std::vector<Reach> reaches;
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const double way = balls[i].isAsleep ? 0.0 : glm::length(balls[i].velocity) * time + fall;
        const double radius = balls[i].radius * (1.0 + margin) + way;
        reaches.push_back({balls[i].position.x - radius, radius, i});
    }
    std::ranges::sort(reaches, {}, [](const Reach &reach) { return std::pair(reach.least, reach.ball); });
    std::vector<BallPair> pairs;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const auto &[least, radius, ball] = reaches[i];
        for (std::size_t k = i + 1; k < reaches.size() && reaches[k].least <= least + 2.0 * radius; ++k) {
            const std::size_t next = reaches[k].ball;
            const glm::dvec3 apart = balls[ball].position - balls[next].position;
            const double reach = radius + reaches[k].radius;
            const bool isAwake = !balls[ball].isAsleep || !balls[next].isAsleep;
            const bool isPiled = balls[ball].isPiled && balls[next].isPiled;
            if ((isAwake || isPiled) && glm::dot(apart, apart) <= reach * reach) {
                pairs.push_back({std::min(ball, next), std::max(ball, next)});
            }
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

std::vector<BallIsland> islandsOf(std::span<const BallState> balls, std::span<const BallPair> pairs)
{
    std::vector<std::size_t> parents(balls.size());
    std::iota(parents.begin(), parents.end(), std::size_t{0});
    for (const BallPair &pair : pairs) {
        const std::size_t one = rootOf(parents, pair.one);
        const std::size_t other = rootOf(parents, pair.other);
        parents[std::max(one, other)] = std::min(one, other); // the root is the first ball
    }
    std::map<std::size_t, BallIsland> islands;
    for (const BallPair &pair : pairs) {
        islands[rootOf(parents, pair.one)].pairs.push_back(pair);
    }
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const auto island = islands.find(rootOf(parents, i));
        if (island != islands.end()) {
            island->second.balls.push_back(i);
        }
    }
    std::vector<BallIsland> awake;
    for (auto &[root, island] : islands) {
        if (std::ranges::any_of(island.balls, [&](std::size_t ball) { return !balls[ball].isAsleep; })) {
            awake.push_back(std::move(island));
        }
    }
    return awake;
}

}
