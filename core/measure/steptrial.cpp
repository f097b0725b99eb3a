// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "steptrial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

#include "core/physics/ballstepper.h"
#include "core/physics/dissertationstep.h"
#include "core/physics/scenephysics.h"
#include "examination.h"

namespace romanesco {

namespace {

constexpr std::array stepsASecond{30, 60, 120, 240, 480, 960};
/// Of the diagonal; and what takes a second.
constexpr double heightShare = 0.25;
constexpr double mostHeight = 4.9;
/// Of the radius: what a ball that lands is off the surface.
constexpr double touching = 1e-9;
constexpr int mostStepsDown = 2'000;

/// Where a ball that comes straight down touches first; nothing where it passes, or only grazes what it passes.
std::optional<glm::dvec3> landingBelow(Search &exact, glm::dvec3 p, double radius, double lowest)
{
    Hit hit;
    for (int i = 0; i < mostStepsDown && p.y > lowest; ++i) {
        exact.closest({.p = p, .nodeBudget = askBudget}, hit);
        const double gap = hit.distance - radius;
        if (hit.promise != Promise::Exact) {
            return std::nullopt;
        }
        if (gap <= touching * radius) {
            return p;
        }
        p.y -= gap; // as far as nothing can be in the way
    }
    return std::nullopt;
}

/// A place where a ball lands, and how far it falls until then.
struct Landing {
    glm::dvec3 place;
    double height;
};

std::vector<Landing> landings(const Subject &subject, const Surface &surface, const StepTrial &trial, std::size_t count,
                              const TrialContext &context)
{
    std::mt19937_64 random(3);
    const auto search = surface.collider->search();
    const double radius = trial.ballRadius;
    std::vector<Landing> found;
    for (std::size_t i = 0; i < 4 * count && found.size() < count && !context.isStopped(); ++i) {
        std::uniform_real_distribution<double> alongX(subject.box.least.x, subject.box.greatest.x);
        std::uniform_real_distribution<double> alongZ(subject.box.least.z, subject.box.greatest.z);
        const double x = alongX(random);
        const double z = alongZ(random);
        const glm::dvec3 above(x, subject.box.greatest.y + 2.0 * radius, z);
        if (const auto landing = landingBelow(*search, above, radius, subject.box.least.y - radius)) {
            // else all would land at the same time of a step
            found.push_back({*landing, trial.height * std::uniform_real_distribution<double>(0.5, 1.0)(random)});
        }
    }
    return found;
}

/// What became of a ball.
struct Fall {
    SearchCost cost = {};
    unsigned queries = 0;
    /// In parts of what it fell with.
    double energyError = 0.0;
    /// Where it was when it touched first.
    std::optional<glm::dvec3> landed = {};
};

/// Drops a ball, and steps it.
class Drop
{
public:
    Drop(const Surface &surface, const StepTrial &trial, const StepRow &row)
        : m_probe(surface)
        , m_trial(trial)
        , m_row(row)
    {
        m_laws.timeStep = row.timeStep;
    }

    Fall onto(const Landing &landing)
    {
        BallState ball{
            {.position = landing.place + glm::dvec3(0.0, landing.height, 0.0), .radius = m_trial.ballRadius}};
        const double energy = energyOf(ball);
        Fall fall;
        const auto steps = static_cast<int>(std::ceil(m_trial.seconds / m_row.timeStep));
        for (int i = 0; i < steps; ++i) {
            const StepReport report = step(ball);
            fall.cost.faceTests += report.cost.faceTests;
            fall.cost.nodeVisits += report.cost.nodeVisits;
            fall.queries += report.queries;
            if (report.contacts > 0 && !fall.landed) {
                fall.landed = landedAt(ball);
            }
        }
        fall.energyError = std::abs(energyOf(ball) - energy) / (glm::length(m_laws.gravity) * landing.height);
        return fall;
    }

private:
    StepReport step(BallState &ball)
    {
        m_paths.clear();
        return m_row.isAsInDissertation ? stepAsInDissertation(ball, m_laws, m_probe, m_row.timeStep)
                                        : stepBall(ball, m_laws, m_probe, m_row.timeStep, &m_paths);
    }

    /// The end of the first path of the step; the dissertation's ball is where it was pushed.
    [[nodiscard]] glm::dvec3 landedAt(const BallState &ball) const
    {
        return m_paths.empty() ? ball.position : m_paths.front().positionAt(m_paths.front().end());
    }

    /// Of a mass of 1.
    [[nodiscard]] double energyOf(const BallState &ball) const
    {
        return 0.5 * glm::dot(ball.velocity, ball.velocity) - glm::dot(m_laws.gravity, ball.position);
    }

    Laws m_laws;
    Probe m_probe;
    const StepTrial &m_trial;
    const StepRow &m_row;
    std::vector<BallPath> m_paths;
};

void tryOne(const Surface &surface, const std::vector<Landing> &landings, const StepTrial &trial,
            std::uint64_t mostOperations, const TrialContext &context, StepRow &row)
{
    Drop drop(surface, trial, row);
    std::vector<double> microseconds;
    std::vector<double> energies;
    std::vector<double> distances;
    std::uint64_t operations = 0;
    for (const Landing &landing : landings) {
        if (operations > mostOperations || context.isStopped()) {
            break;
        }
        const double begin = threadSeconds();
        const Fall fall = drop.onto(landing);
        microseconds.push_back(1e6 * (threadSeconds() - begin) / trial.seconds);
        operations += operationsOf(fall.cost);
        row.faceTests += static_cast<double>(fall.cost.faceTests) / trial.seconds;
        row.queries += fall.queries / trial.seconds;
        energies.push_back(fall.energyError);
        row.missed.of += 1;
        row.missed.count += fall.landed ? 0 : 1;
        if (fall.landed) {
            distances.push_back(glm::distance(*fall.landed, landing.place) / trial.ballRadius);
        }
    }
    row.balls = energies.size();
    if (row.balls == 0) {
        return;
    }
    row.faceTests /= static_cast<double>(row.balls);
    row.queries /= static_cast<double>(row.balls);
    row.microseconds = spreadOf(std::move(microseconds));
    row.energyMedian = quantile(energies, 0.5);
    row.energyWorst = std::ranges::max(energies);
    if (!distances.empty()) {
        row.landingMedian = quantile(distances, 0.5);
        row.landingWorst = std::ranges::max(distances);
    }
}

std::expected<StepTrial, std::string> tried(const Subject &subject, const StepTrial::Options &options,
                                            const TrialContext &context)
{
    const auto surface = surfaceOf(subject.scene, {.kind = ColliderKind::Exact}, context.stop);
    if (!surface) {
        return std::unexpected(surface.error());
    }
    StepTrial trial;
    trial.ballRadius = options.ballRadius.value_or(defaultBallRadius(subject));
    trial.height = std::min(heightShare * subject.diagonal, mostHeight);
    trial.seconds = 3.0 * std::sqrt(2.0 * trial.height / glm::length(Laws().gravity));
    context.tell("where balls land", 0.0);
    const std::vector<Landing> places = landings(subject, *surface, trial, options.balls, context);
    if (places.empty() && !context.isStopped()) {
        return std::unexpected("no ball that comes down from above lands on the surface");
    }
    for (const bool isAsInDissertation : {false, true}) {
        for (const int steps : stepsASecond) {
            StepRow row{.isAsInDissertation = isAsInDissertation, .timeStep = 1.0 / steps};
            if (context.isStopped()) {
                return std::unexpected("cancelled");
            }
            context.tell(nameOf(row), static_cast<double>(trial.rows.size()) / (2.0 * stepsASecond.size()));
            tryOne(*surface, places, trial, options.mostOperations, context, row);
            trial.rows.push_back(row);
        }
    }
    return context.isStopped() ? std::expected<StepTrial, std::string>(std::unexpect, "cancelled") : std::move(trial);
}

}

std::span<const int> trialStepsASecond()
{
    return stepsASecond;
}

std::string nameOf(const StepRow &row)
{
    return std::format("{} 1/{:.0f}", row.isAsInDissertation ? "dissertation" : "romanesco", 1.0 / row.timeStep);
}

std::expected<StepTrial, std::string> tryTimeSteps(const std::shared_ptr<const Scene> &scene,
                                                   std::span<const Ball> balls, const StepTrial::Options &options,
                                                   const TrialContext &context)
{
    return Subject::of(scene, balls).and_then([&](const Subject &subject) { return tried(subject, options, context); });
}

}
