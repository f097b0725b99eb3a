// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "drops.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "core/physics/world.h"

namespace romanesco::bench {

namespace {

constexpr double fallSeconds = 3.0;
constexpr double restSeconds = 8.0;

World worldFor(const ShrinkingGround &ground, const Manner &manner)
{
    World::Options options{.isAsInDissertation = manner.isAsInDissertation, .areSolid = false, .threads = 1};
    options.laws.timeStep = 1.0 / manner.rate;
    return World(ground.surface(manner.collider), options);
}

bool isPast(const ShrinkingGround &ground, const Ball &ball)
{
    const Box &box = ground.box;
    const double r = ball.radius;
    const glm::dvec3 &p = ball.position;
    return p.y < box.least.y - r || p.x < box.least.x - r || p.x > box.greatest.x + r || p.z < box.least.z - r
        || p.z > box.greatest.z + r;
}

double distanceTo(const Surface &surface, const glm::dvec3 &p)
{
    Hit hit;
    surface.collider->search()->closest({.p = p}, hit);
    return hit.distance;
}

class BallSource
{
public:
    BallSource(const ShrinkingGround &ground, double radius)
        : m_box(ground.box)
        , m_radius(radius)
    {
    }

    Ball next()
    {
        const double x = uniform(m_box.least.x, m_box.greatest.x);
        const double z = uniform(m_box.least.z, m_box.greatest.z);
        const double height = uniform(1.5 * m_radius, 1.5 * m_radius + 0.1 * ShrinkingGround::size);
        return {.position = {x, m_box.greatest.y + height, z}, .radius = m_radius, .restitution = 0.0};
    }

private:
    double uniform(double least, double greatest)
    {
        return std::uniform_real_distribution<double>(least, greatest)(m_random);
    }

    Box m_box;
    double m_radius;
    std::mt19937_64 m_random{1};
};

/// Steps a ball that rests or shrinks, and tells when it has fallen.
class Holding
{
public:
    Holding(const ShrinkingGround &ground, const Ball &resting, const Manner &manner)
        : m_world(worldFor(ground, manner))
        , m_rate(manner.rate)
    {
        const Surface &surface = ground.surface(manner.collider);
        Ball ball = resting;
        ball.velocity = {};
        while (distanceTo(surface, ball.position) < ball.radius && !isPast(ground, ball)
               && ball.position.y < ground.box.greatest.y + ball.radius) {
            ball.position.y += 0.01 * ball.radius;
        }
        m_world.add(ball);
        m_held = ball;
        m_lowest = resting.position.y - 2.0 * resting.radius;
    }

    [[nodiscard]] Ball ball() const { return m_world.balls().front(); }
    [[nodiscard]] const Ball &held() const { return m_held; }

    void startShrinking()
    {
        World::Options options = m_world.options();
        options.shrinkRate = -std::log(Shrinking::leastShare) / Shrinking::shrinkSeconds;
        m_world.setRules(options);
    }

    /// Whether it has fallen.
    bool step()
    {
        m_world.step();
        const Ball now = ball();
        if (m_world.reports().front().contacts > 0 || m_world.balls().front().isAsleep) {
            m_held = now;
        }
        return m_held.position.y - now.position.y > now.radius || now.position.y < m_lowest;
    }

    /// So many seconds, or until it has fallen.
    bool fallsWithin(double seconds)
    {
        const auto steps = static_cast<int>(std::lround(seconds * m_rate));
        for (int i = 0; i < steps; ++i) {
            if (step()) {
                return true;
            }
        }
        return false;
    }

private:
    World m_world;
    double m_rate;
    double m_lowest;
    Ball m_held;
};

/// The ball as it comes to rest; none where it does not.
std::optional<Ball> rested(const ShrinkingGround &ground, const Ball &ball)
{
    const Manner manner{.isAsInDissertation = false, .rate = 240.0};
    World world = worldFor(ground, manner);
    world.add(ball);
    const auto steps = static_cast<int>(std::lround(restSeconds * manner.rate));
    for (int i = 0; i < steps && !isPast(ground, world.balls().front()); ++i) {
        world.step();
        if (world.balls().front().isAsleep) {
            return world.balls().front();
        }
    }
    return std::nullopt;
}

}

double gapOf(const ShrinkingGround &ground, const Ball &ball)
{
    return distanceTo(ground.exact, ball.position) / ball.radius - 1.0;
}

FirstContact firstContact(const ShrinkingGround &ground, const Ball &ball, const Manner &manner)
{
    World world = worldFor(ground, manner);
    world.add(ball);
    FirstContact made;
    const auto steps = static_cast<int>(std::lround(fallSeconds * manner.rate));
    for (int i = 0; i < steps; ++i) {
        world.step();
        const Ball &now = world.balls().front();
        if (world.reports().front().contacts > 0) {
            made.ball = now;
            made.gap = gapOf(ground, now);
            break;
        }
        if (isPast(ground, now)) {
            break;
        }
        made.depth = std::max(made.depth, -gapOf(ground, now));
    }
    return made;
}

std::vector<Ball> ballsThatHit(const ShrinkingGround &ground, double radius, std::size_t count)
{
    BallSource source(ground, radius);
    std::vector<Ball> balls;
    while (balls.size() < count) {
        const Ball ball = source.next();
        if (firstContact(ground, ball, {.isAsInDissertation = false, .rate = 240.0}).ball) {
            balls.push_back(ball);
        }
    }
    return balls;
}

std::vector<Ball> restingBalls(const ShrinkingGround &ground, double radius, std::size_t count)
{
    BallSource source(ground, radius);
    std::vector<Ball> balls;
    while (balls.size() < count) {
        const std::optional<Ball> resting = rested(ground, source.next());
        const auto isThere = [&](const Ball &ball) {
            return glm::distance(ball.position, resting->position) < 0.1 * radius;
        };
        if (resting && std::ranges::none_of(balls, isThere)) {
            Holding holding(ground, *resting, {});
            if (!holding.fallsWithin(Shrinking::settleSeconds) && isThere(holding.ball())) {
                balls.push_back(*resting);
            }
        }
    }
    return balls;
}

Shrinking shrunk(const ShrinkingGround &ground, const Ball &resting, const Manner &manner)
{
    Holding holding(ground, resting, manner);
    Shrinking made;
    bool falls = holding.fallsWithin(Shrinking::settleSeconds);
    if (!falls) {
        if (glm::distance(holding.ball().position, resting.position) > resting.radius) {
            return made;
        }
        made.rest = holding.ball();
        holding.startShrinking();
        falls = holding.fallsWithin(Shrinking::shrinkSeconds);
    }
    if (falls) {
        made.held = holding.held();
        made.fallen = holding.ball();
    }
    return made;
}

}
