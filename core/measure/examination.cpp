// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "examination.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <utility>

#include <glm/geometric.hpp>

#include "ballasks.h"
#include "core/physics/scenephysics.h"
#include "scenefaces.h"

namespace romanesco {

namespace {

constexpr double farthest = 1e100;
constexpr double shareOfDiagonal = 0.02;
/// Of a set: some two seconds.
constexpr std::uint64_t mostOperations = 20'000'000;

class Examiner
{
public:
    Examiner(const Subject &subject, const Surface &surface, const TrialContext &context)
        : m_surface(surface)
        , m_context(context)
        , m_size(std::max(glm::length(subject.box.least), glm::length(subject.box.greatest)))
    {
    }

    /// What nextAsk() gives until it gives nothing.
    template<typename NextAsk>
    Examination answered(QuerySet set, NextAsk nextAsk) const
    {
        Asker asker(*m_surface.collider);
        Examination examination{.queries = set, .size = m_size};
        std::uint64_t operations = 0;
        while (operations < mostOperations && !m_context.isStopped()) {
            const std::optional<Ask> ask = nextAsk();
            if (!ask) {
                break;
            }
            const Answer answer = asker(*ask, m_context.stop);
            operations += operationsOf(answer.cost);
            if (answer.isExact) {
                examination.asks.push_back(*ask);
                examination.answers.push_back(answer);
            } else {
                ++examination.undecided;
            }
        }
        return examination;
    }

private:
    const Surface &m_surface;
    const TrialContext &m_context;
    double m_size;
};

}

std::expected<Subject, std::string> Subject::of(std::shared_ptr<const Scene> scene, std::span<const Ball> balls)
{
    Subject subject{.scene = std::move(scene), .balls = balls};
    for (const SceneItem &item : subject.scene->items) {
        const bool hasFaces = !item.model->boxes.at(item.model->graph, 0).isEmpty();
        if (item.kind != SceneDescription::Kind::Ball && hasFaces) {
            subject.surface.push_back(item);
        }
    }
    if (subject.surface.empty()) {
        return std::unexpected("there is no surface to measure");
    }
    subject.box = extentOf(subject.surface);
    subject.diagonal = glm::length(subject.box.size());
    if (!(std::max(glm::length(subject.box.least), glm::length(subject.box.greatest)) <= farthest)) {
        return std::unexpected("coordinates beyond 10^100 are too large to be measured");
    }
    if (subject.diagonal == 0.0) {
        return std::unexpected("the surface is a single point: there is nothing to measure");
    }
    return subject;
}

double defaultBallRadius(const Subject &subject)
{
    return subject.balls.empty() ? shareOfDiagonal * subject.diagonal
                                 : std::ranges::min(subject.balls, {}, &Ball::radius).radius;
}

std::uint64_t operationsOf(const SearchCost &cost)
{
    return cost.faceTests + 4 * cost.nodeVisits;
}

std::expected<std::vector<Examination>, std::string> examinations(const Subject &subject, std::size_t points,
                                                                  double ballRadius, const TrialContext &context)
{
    const auto surface = surfaceOf(subject.scene, {.kind = ColliderKind::Exact}, context.stop);
    if (!surface) {
        return std::unexpected(surface.error());
    }
    const Examiner examiner(subject, *surface, context);
    std::vector<Examination> made;
    SceneFaces faces(*subject.scene, subject.diagonal);
    for (const QuerySet set : {QuerySet::Uniform, QuerySet::Near, QuerySet::Pocket}) {
        if (context.isStopped()) {
            break;
        }
        context.tell(std::format("places, {}", nameOf(set)), 0.0);
        QueryPlaces places(subject.box, *surface->collider, faces);
        std::size_t left = points;
        made.push_back(examiner.answered(set, [&]() -> std::optional<Ask> {
            if (left == 0 || operationsOf(places.cost()) > mostOperations) {
                return std::nullopt;
            }
            --left;
            return Ask{Query{.p = places.draw(set), .nodeBudget = askBudget}, ballRadius};
        }));
    }
    if (!subject.balls.empty() && !context.isStopped()) {
        context.tell("what balls ask", 0.0);
        const std::vector<Ask> asks = asksOfBalls(*surface, subject.balls, points, context.stop);
        auto next = asks.begin();
        made.push_back(examiner.answered(QuerySet::Balls,
                                         [&] { return next == asks.end() ? std::nullopt : std::optional(*next++); }));
    }
    std::erase_if(made, [](const Examination &examination) { return examination.asks.empty(); });
    return context.isStopped() ? std::expected<std::vector<Examination>, std::string>(std::unexpect, "cancelled")
                               : std::move(made);
}

}
