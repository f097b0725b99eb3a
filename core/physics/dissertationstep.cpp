// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "dissertationstep.h"

#include <glm/geometric.hpp>

namespace romanesco {

StepReport stepAsInDissertation(BallState &ball, const Laws &laws, Probe &probe, double time)
{
    probe.begin(laws.budget);
    ball.velocity += time * laws.gravity;
    ball.position += time * ball.velocity;
    const Probe::Nearest nearest = probe.nearest(ball.position, ball.radius);
    StepReport report;
    if (nearest.isFound && nearest.distance < ball.radius) {
        const glm::dvec3 &n = nearest.direction;
        ball.position += (ball.radius - nearest.distance) * n;
        ball.velocity -= (1.0 + ball.restitution) * glm::dot(ball.velocity, n) * n;
        report.contacts = 1;
    }
    report.cost = probe.cost();
    report.queries = probe.queries();
    return report;
}

}
