// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cmath>
#include <cstdint>

#include "core/physics/ballstepper.h"
#include "tests/core/physics/grounds.h"
#include "tests/core/physics/writtensurface.h"

namespace romanesco::test {

/// Follows balls all along their paths, and keeps by how much the laws were broken at most.
class Referee
{
public:
    explicit Referee(const WrittenSurface &surface)
        : m_surface(surface)
    {
    }

    /// A step, watched.
    StepReport step(BallState &ball, const Laws &laws, Probe &probe)
    {
        const BallState before = ball;
        std::vector<BallPath> paths;
        const StepReport report = stepBall(ball, laws, probe, laws.timeStep, &paths);
        const double radius = before.radius;
        double least = 2.0 * radius;
        glm::dvec3 at = before.position;
        for (const BallPath &path : paths) {
            least = std::min(least, m_surface.distance(at, path.from.position, least)); // where it was pushed
            least = std::min(least, leastOf(path, radius, least));
            at = path.positionAt(path.end());
            if (&path != &paths.front()) {
                against = std::max(against, againstOf(path));
            }
        }
        least = std::min(least, m_surface.distance(at, ball.position, least));
        penetration = std::max(penetration, 1.0 - least / radius);
        const double allowed = 1e-3 * glm::length(laws.gravity) * radius * (report.contacts + 1)
            + 1e-13 * (glm::dot(before.velocity, before.velocity) + std::abs(energyOf(before, laws)));
        won = std::max(won, (energyOf(ball, laws) - energyOf(before, laws)) / allowed);
        ++steps;
        exhausted += report.isExhausted ? 1 : 0;
        contacts += report.contacts;
        mostQueries = std::max(mostQueries, report.queries);
        return report;
    }

    /// Of the radius; 1 where a ball has gone through a face.
    double penetration = 0.0;
    /// Of the radius: how far a ball went against what it touched.
    double against = 0.0;
    /// Energy, as a share of what corrections may add: a thousandth of |g|·r a contact.
    double won = 0.0;
    std::uint64_t steps = 0;
    /// Those of which the rest was lost.
    std::uint64_t exhausted = 0;
    std::uint64_t contacts = 0;
    unsigned mostQueries = 0;

private:
    /// A parabola is tried as chords that it is within a ten-thousandth of the radius of.
    [[nodiscard]] double leastOf(const BallPath &path, double radius, double least) const
    {
        const double sag = glm::length(path.acceleration) * path.time * path.time / 8.0;
        const double chords = std::ceil(std::sqrt(sag / (1e-4 * radius)) + 1e-9);
        for (double i = 0; i < chords; ++i) {
            const double found = m_surface.distance(path.positionAt(path.start + i / chords * path.time),
                                                    path.positionAt(path.start + (i + 1) / chords * path.time), least);
            least = std::min(least, found + sag / (chords * chords));
        }
        return least;
    }

    /// By how much of its radius a ball in the air goes on against what it touches. (One that slides does, by what its skin
    /// reaches, where it comes to the next of coplanar faces.)
    [[nodiscard]] double againstOf(const BallPath &path) const
    {
        const BallState &ball = path.from;
        double most = 0.0;
        if (!ball.supports.isEmpty()) {
            return most;
        }
        for (const glm::dvec3 &n : m_surface.directions(ball.position, ball.radius * (1.0 + 5e-5))) {
            most = std::max(most, -glm::dot(ball.velocity, n) * path.time / ball.radius);
        }
        return most;
    }

    const WrittenSurface &m_surface;
};

}
