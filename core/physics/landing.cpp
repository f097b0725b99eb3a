// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "landing.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

constexpr int mostResponses = 32;
/// Of the room that there is: what would be as near in passing is touched. Sweeps stop there.
constexpr double passing = 0.75;
/// Of gravity: a force that is as little against a direction is along it.
constexpr double alongShare = 1e-9;
/// What a direction takes from a velocity, beside what goes along it.
constexpr double mostOfBounce = 10.0;

/// Whether going on with v would pass by something ahead, and not come nearer to it than to what is touched now: an edge within
/// a plane that the ball lies on.
bool isPassed(const BallStep &step, const glm::dvec3 &v, const Probe::Nearest &ahead)
{
    const double speed = glm::length(v);
    const double side = glm::length(glm::cross(v, ahead.direction));
    return step.room() > 0.0
        && ahead.clearance * side >= speed * (step.radius() + passing * std::min(step.room(), step.skin()));
}

/// v, turned away from each direction by a little more than these may be off, so that none is found to be in the way again.
glm::dvec3 leaning(const glm::dvec3 &v, const Supports &supports, double tilt)
{
    const double speed = glm::length(v);
    glm::dvec3 turned = v;
    for (const glm::dvec3 &n : supports.directions()) {
        const double off = glm::dot(turned, n);
        if (off < tilt * speed) {
            turned += (tilt * speed - off) * n;
        }
    }
    return withEnergy(turned, speed * speed);
}

/// Whether all the bounces that would follow from leaving a surface at a speed v fit into a time step: of a ball that is
/// pulled back with g the first takes 2·v/g, and each e times as long as the one before. Supports hold it meanwhile.
bool isLeftOut(const BallStep &step, Supports supports, const glm::dvec3 &n, double speed)
{
    if (speed <= step.still()) {
        return true;
    }
    supports.keepIf([&](const glm::dvec3 &held) { return glm::dot(held, n) < 1.0 - alongShare; });
    const double pull = -glm::dot(supports.allowed(step.laws().gravity), n);
    return pull > 0.0 && 2.0 * speed < step.laws().timeStep * pull * (1.0 - step.ball().restitution);
}

/// v after it has hit planes, all at once: what goes against them is turned round (Moreau 1988).
glm::dvec3 bounced(const BallStep &step, const glm::dvec3 &v, const Supports &planes)
{
    const BallState &ball = step.ball();
    const glm::dvec3 along = planes.allowed(v);
    const bool isAllLeftOut = std::ranges::all_of(planes.directions(), [&](const glm::dvec3 &n) {
        return isLeftOut(step, ball.supports, n, -ball.restitution * glm::dot(v, n));
    });
    return isAllLeftOut ? leaning(along, planes, 4.0 * step.tilt()) : along - ball.restitution * (v - along);
}

/// Takes what the ball would leave with only to be back at once. Whether there was any of that.
bool takeLeftOut(BallStep &step, const Supports &touching)
{
    glm::dvec3 &v = step.ball().velocity;
    Supports held = touching;
    held.keepIf([&](const glm::dvec3 &n) { return glm::dot(v, n) <= step.still(); });
    bool hasChanged = false;
    for (const glm::dvec3 &n : touching.directions()) {
        const double along = glm::dot(v, n);
        if (held.holds(n) || !isLeftOut(step, held, n, along)) {
            continue;
        }
        // Between directions that hardly differ, as at an edge, being held by both would take what goes across them too.
        Supports both = held;
        both.add(n);
        const double taken = glm::length(v - both.along(v));
        if (taken <= mostOfBounce * along || isLeftOut(step, held, n, taken)) {
            held = both;
            hasChanged = true;
        }
    }
    if (hasChanged) {
        v = leaning(held.along(v), held, 4.0 * step.tilt());
    }
    return hasChanged;
}

/// Of all that touches, what it lies against.
void keepSupports(BallStep &step, Supports touching)
{
    BallState &ball = step.ball();
    const double still = step.still();
    touching.keepIf([&](const glm::dvec3 &n) { return glm::dot(ball.velocity, n) <= still; });
    const glm::dvec3 &gravity = step.laws().gravity;
    const glm::dvec3 pull = touching.allowed(gravity);
    const double along = alongShare * glm::length(gravity);
    touching.keepIf([&](const glm::dvec3 &n) { return glm::dot(pull, n) <= along; });
    ball.supports = touching;
}

/// All that gravity pulls the ball against, one after another.
Supports pushedAgainst(BallStep &step)
{
    Supports touching;
    touching.add(step.direction());
    const glm::dvec3 &gravity = step.laws().gravity;
    const double nothing = alongShare * glm::length(gravity);
    while (!step.probe().isExhausted()) {
        const glm::dvec3 pull = leaning(touching.allowed(gravity), touching, 4.0 * step.tilt());
        if (glm::length(pull) <= nothing) {
            break;
        }
        const auto ahead = step.probe().nearest(step.ball().position, step.radius() + step.skin(), pull);
        if (!ahead.isFound || ahead.clearance > step.radius() + step.skin() || touching.holds(ahead.direction)
            || !touching.add(ahead.direction)) {
            break;
        }
    }
    return touching;
}

}

void land(BallStep &step)
{
    BallState &ball = step.ball();
    glm::dvec3 &v = ball.velocity;
    Supports seen;
    // What the ball moves against before it bounces is hit at once, in whatever order it is found.
    glm::dvec3 before = v;
    Supports atOnce;
    Supports touching = ball.supports;
    touching.add(step.direction());
    glm::dvec3 n = step.direction();
    bool isOver = glm::dot(v, n) >= 0.0;
    for (int response = 0; response < mostResponses; ++response) {
        if (isOver || response > 0) {
            if (v == glm::dvec3(0.0) || step.probe().isExhausted()) {
                break;
            }
            const auto ahead = step.probe().nearest(ball.position, step.radius() + step.skin(), v);
            if (!ahead.isFound || ahead.clearance > step.radius() + step.skin() || isPassed(step, v, ahead)) {
                break;
            }
            n = ahead.direction;
        }
        isOver = true;
        const bool isNew = !seen.holds(n);
        if (!seen.add(n) || response + 1 == mostResponses) {
            v = glm::dvec3(0.0); // wedged
            break;
        }
        touching.add(n);
        if (isNew && glm::dot(v, n) < 0.0) {
            if (glm::dot(before, n) >= 0.0) {
                // it is only the bounce that brings the ball there
                before = v;
                atOnce.clear();
            }
            atOnce.add(n);
            v = bounced(step, before, atOnce);
        } else {
            v = leaning(seen.allowed(v), seen, 4.0 * step.tilt());
        }
    }
    step.report().contacts += static_cast<unsigned>(seen.count());
    (void)takeLeftOut(step, touching);
    keepSupports(step, touching);
}

void findSupports(BallStep &step)
{
    keepSupports(step, pushedAgainst(step));
}

bool settle(BallStep &step)
{
    const Supports touching = pushedAgainst(step);
    const bool hasChanged = takeLeftOut(step, touching);
    keepSupports(step, touching);
    return hasChanged;
}

}
