// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballstepper.h"

#include <algorithm>
#include <cmath>

#include "flight.h"
#include "sliding.h"

namespace romanesco {

namespace {

/// Colliders take coordinates so large; a ball that has fallen farther stays there.
constexpr double farthest = 1e100;

bool isFarAway(const glm::dvec3 &p)
{
    return !(std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest);
}

}

StepReport stepBall(BallState &ball, const Laws &laws, Probe &probe, double time, std::vector<BallPath> *paths)
{
    BallStep step(ball, laws, probe, time, paths);
    while (step.left() > 0.0 && !ball.isAsleep && !isFarAway(ball.position)) {
        if (probe.isExhausted()) {
            step.lose();
        } else if (ball.supports.isEmpty()) {
            fly(step);
        } else {
            slide(step);
        }
    }
    StepReport &report = step.report();
    report.cost = probe.cost();
    report.queries = probe.queries();
    if (ball.isAsleep) {
        report.contacts = static_cast<unsigned>(ball.supports.count());
    }
    return report;
}

}
