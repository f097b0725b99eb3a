// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "meeting.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace romanesco {

namespace {

/// Of the radii: what is as near touches.
constexpr double touching = 1e-9;
constexpr int mostAdvances = 200;

/// One ball as the other sees it, from the beginning of a time in which both have one acceleration.
struct Approach {
    glm::dvec3 apart;
    glm::dvec3 velocity;
    glm::dvec3 acceleration;
    double radii;
    double time;
};

std::optional<double> meetingOfLines(const Approach &approach)
{
    const double a = glm::dot(approach.velocity, approach.velocity);
    const double b = glm::dot(approach.apart, approach.velocity);
    const double c = glm::dot(approach.apart, approach.apart) - approach.radii * approach.radii;
    if (b >= 0.0) {
        return std::nullopt; // not nearer
    }
    if (c <= 0.0) {
        return 0.0;
    }
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) {
        return std::nullopt;
    }
    const double time = c / (-b + std::sqrt(discriminant));
    return time <= approach.time ? std::optional(time) : std::nullopt;
}

std::optional<double> meetingOfParabolas(const Approach &approach)
{
    const double fastest = glm::length(approach.velocity) + glm::length(approach.acceleration) * approach.time;
    double time = 0.0;
    for (int i = 0; i < mostAdvances && time <= approach.time; ++i) {
        const glm::dvec3 apart =
            approach.apart + time * approach.velocity + (0.5 * time * time) * approach.acceleration;
        const double gap = glm::length(apart) - approach.radii;
        const bool isNearing = glm::dot(apart, approach.velocity + time * approach.acceleration) < 0.0;
        if (gap <= touching * approach.radii && isNearing) {
            return time;
        }
        // what parts goes on parting until the acceleration has used that up
        const double parting = glm::dot(apart, approach.velocity + time * approach.acceleration) / glm::length(apart);
        time += std::max(
            {gap / fastest, parting / glm::length(approach.acceleration), touching * approach.radii / fastest});
    }
    return std::nullopt;
}

std::optional<double> meetingOf(const Approach &approach)
{
    return approach.acceleration == glm::dvec3(0.0) ? meetingOfLines(approach) : meetingOfParabolas(approach);
}

}

std::optional<double> meetingOf(std::span<const BallPath> one, std::span<const BallPath> other, double from)
{
    std::size_t i = 0;
    std::size_t k = 0;
    while (i < one.size() && k < other.size()) {
        const BallPath &a = one[i];
        const BallPath &b = other[k];
        const double start = std::max({a.start, b.start, from});
        const double end = std::min(a.end(), b.end());
        if (end > start) {
            const auto met =
                meetingOf({a.positionAt(start) - b.positionAt(start), a.velocityAt(start) - b.velocityAt(start),
                           a.acceleration - b.acceleration, a.from.radius + b.from.radius, end - start});
            if (met) {
                return start + *met;
            }
        }
        ++(a.end() <= b.end() ? i : k);
    }
    return std::nullopt;
}

void collide(BallState &one, BallState &other, double pull, double timeStep)
{
    const glm::dvec3 apart = one.position - other.position;
    const double distance = glm::length(apart);
    const glm::dvec3 n = distance > 0.0 ? apart / distance : glm::dvec3(0.0, 1.0, 0.0);
    const double against = -glm::dot(one.velocity - other.velocity, n);
    if (against <= 0.0) {
        return;
    }
    double e = std::sqrt(one.restitution * other.restitution);
    if (pull > 0.0 && 2.0 * e * against < timeStep * pull * (1.0 - e)) {
        e = 0.0;
    }
    one.foresight = other.foresight = {};
    // masses are as the cubes of the radii
    const double ratio = one.radius / other.radius;
    const double shareOfOne = 1.0 / (1.0 + ratio * ratio * ratio);
    one.velocity += (1.0 + e) * against * shareOfOne * n;
    other.velocity -= (1.0 + e) * against * (1.0 - shareOfOne) * n;
}

}
