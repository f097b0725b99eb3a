// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "dropping.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>
#include <numeric>

namespace romanesco::bench {

namespace {

/// Of all threads of the program, in seconds.
double cpuTime()
{
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

bool isPast(const Box &box, const glm::dvec3 &position, double radius)
{
    return position.y < box.least.y - radius || position.x < box.least.x - radius
        || position.x > box.greatest.x + radius || position.z < box.least.z - radius
        || position.z > box.greatest.z + radius;
}

/// The largest sum of so many in a row.
double largestSum(const std::vector<double> &values, std::size_t length)
{
    length = std::min(length, values.size());
    double sum = std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(length), 0.0);
    double most = sum;
    for (std::size_t i = length; i < values.size(); ++i) {
        sum += values[i] - values[i - length];
        most = std::max(most, sum);
    }
    return most;
}

}

Timing timed(const Engine &engine, const Ground &ground, const Drop &drop, int rounds, bool keepsPositions)
{
    const std::vector<Ball> balls = ballsOver(ground, drop.start, drop.radius, drop.balls, drop.speed);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> cpu(drop.steps, infinity);
    std::vector<double> wall(drop.steps, infinity);
    Timing timing;
    std::vector<Falling::State> states;
    for (int round = 0; round < rounds; ++round) {
        const auto falling = engine.fall(balls, drop.options);
        for (std::size_t step = 0; step < drop.steps; ++step) {
            const double cpuBefore = cpuTime();
            const auto wallBefore = std::chrono::steady_clock::now();
            falling->step();
            wall[step] = std::min(wall[step],
                                  std::chrono::duration<double>(std::chrono::steady_clock::now() - wallBefore).count());
            cpu[step] = std::min(cpu[step], cpuTime() - cpuBefore);
            if (round > 0) {
                continue;
            }
            falling->look(states);
            for (const Falling::State &state : states) {
                const bool counts = state.isAwake && !isPast(ground.box, state.position, drop.radius);
                timing.ballSteps += counts ? 1 : 0;
                timing.touching += counts && state.isTouching ? 1 : 0;
            }
            if (keepsPositions) {
                std::vector<glm::dvec3> &positions = timing.positions.emplace_back();
                for (const Falling::State &state : states) {
                    positions.push_back(state.position);
                }
            }
        }
        timing.lost = falling->lostSteps();
    }
    timing.cpuSeconds = std::accumulate(cpu.begin(), cpu.end(), 0.0);
    timing.wallSeconds = std::accumulate(wall.begin(), wall.end(), 0.0);
    timing.slowest = largestSum(wall, static_cast<std::size_t>(0.25 / drop.options.timeStep));
    return timing;
}

Sinking sunk(const Collider &exact, const std::vector<std::vector<glm::dvec3>> &positions, double radius)
{
    const auto search = exact.search();
    Hit hit;
    Touch touch;
    const std::size_t count = positions.front().size();
    std::vector<double> deepest(count, 0.0);
    std::vector<bool> hasPassed(count, false);
    for (std::size_t step = 0; step < positions.size(); ++step) {
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec3 &position = positions[step][i];
            search->closest({.p = position, .radius = radius}, hit);
            if (hit.isFound()) {
                deepest[i] = std::max(deepest[i], 1.0 - hit.distance / radius);
            }
            if (step > 0 && !hasPassed[i]) {
                const glm::dvec3 &before = positions[step - 1][i];
                search->sweep({.p = before, .v = position - before, .radius = 1e-9 * radius}, touch);
                hasPassed[i] = touch.isFound();
            }
        }
    }
    Sinking sinking;
    sinking.most = std::ranges::max(deepest);
    std::ranges::sort(deepest);
    sinking.median = deepest[count / 2];
    sinking.tunnelled = static_cast<std::size_t>(std::ranges::count(hasPassed, true));
    return sinking;
}

}
