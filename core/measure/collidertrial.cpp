// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "collidertrial.h"

#include <algorithm>
#include <array>
#include <format>
#include <utility>

#include "core/scene/scenecollider.h"
#include "scenefaces.h"
#include "words.h"

namespace romanesco {

namespace {

using Options = ColliderTrial::Options;
using Result = std::expected<ColliderTrial, std::string>;

constexpr std::array tolerances{1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 0.5};
constexpr int timedRounds = 7;
constexpr double leastRoundSeconds = 0.004;
constexpr int mostBuilds = 7;
constexpr double buildSeconds = 0.1;

/// A kind with its tolerance.
struct Way {
    ColliderKind kind;
    std::optional<double> tolerance = {};
};

std::vector<Way> allWays()
{
    std::vector<Way> ways{{ColliderKind::Exact}};
    for (const double tolerance : tolerances) {
        ways.push_back({ColliderKind::Approximate, tolerance});
    }
    for (const ColliderKind kind :
         {ColliderKind::Greedy, ColliderKind::Octree, ColliderKind::Bvh, ColliderKind::Simple}) {
        ways.push_back({kind});
    }
    return ways;
}

/// Why a kind is not tried that looks at all faces or writes them out; empty where it is.
std::string obstacleTo(ColliderKind kind, const std::optional<Count> &faces, std::uint64_t most)
{
    if (kind != ColliderKind::Octree && kind != ColliderKind::Bvh && kind != ColliderKind::Simple) {
        return {};
    }
    const std::optional<std::uint64_t> number = faces ? faces->toInteger() : std::nullopt;
    return number && *number <= most ? std::string()
                                     : std::format("not possible: {} (at most {})", facesText(faces), grouped(most));
}

/// Measures how long a collider takes for its part of an examination, by the round.
std::vector<double> nanosecondsOf(const Collider &collider, const Examination &examination, std::size_t asked,
                                  const std::stop_token &stop)
{
    Asker asker(collider);
    std::size_t next = 0;
    const auto askOne = [&] {
        (void)asker(examination.asks[next], stop);
        next = next + 1 < asked ? next + 1 : 0;
    };
    for (std::size_t i = 0; i < asked / 16; ++i) {
        askOne(); // a search grows at first
    }
    // looking at the clock takes as long as a query: only now and then
    const std::size_t atATime = std::max<std::size_t>(asked / timedRounds, 1);
    std::vector<double> rounds;
    while (rounds.size() < std::min<std::size_t>(timedRounds, asked) && !stop.stop_requested()) {
        const double begin = threadSeconds();
        double seconds = 0.0;
        std::size_t count = 0;
        do {
            for (std::size_t i = 0; i < atATime && !stop.stop_requested(); ++i) {
                askOne();
            }
            count += atATime;
            seconds = threadSeconds() - begin;
        } while (seconds < leastRoundSeconds && !stop.stop_requested());
        rounds.push_back(1e9 * seconds / static_cast<double>(count));
    }
    return rounds;
}

class Trial
{
public:
    Trial(const Subject &subject, const Options &options, const TrialContext &context)
        : m_subject(subject)
        , m_options(options)
        , m_context(context)
    {
    }

    Result run()
    {
        m_context.tell("faces", 0.0);
        m_made.faces = facesOf(m_subject.surface);
        m_made.diagonal = m_subject.diagonal;
        m_made.ballRadius = m_options.ballRadius.value_or(defaultBallRadius(m_subject));
        auto examined = examinations(m_subject, m_options.points, m_made.ballRadius, m_context);
        if (!examined) {
            return std::unexpected(examined.error());
        }
        m_examinations = std::move(*examined);
        for (const Examination &examination : m_examinations) {
            const auto touching = std::ranges::count(examination.answers, true, &Answer::touches);
            m_made.sets.push_back({.queries = examination.queries,
                                   .points = examination.asks.size(),
                                   .touching = static_cast<std::size_t>(touching),
                                   .undecided = examination.undecided});
        }
        return tryAll();
    }

private:
    Result tryAll()
    {
        const std::vector<Way> ways = allWays();
        for (std::size_t i = 0; i < ways.size() && !m_context.isStopped(); ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(ways.size());
            m_context.tell(nameOf(ColliderRow{ways[i].kind, ways[i].tolerance}), share);
            tryOne(ways[i]);
        }
        if (m_context.isStopped()) {
            return std::unexpected("cancelled");
        }
        std::ranges::stable_sort(m_made.rows, {}, &ColliderRow::queries);
        return std::move(m_made);
    }

    void tryOne(const Way &way)
    {
        ColliderRow row{way.kind, way.tolerance};
        row.reason = obstacleTo(way.kind, m_made.faces, m_options.mostFaces);
        std::optional<SceneCollider> collider = row.reason.empty() ? build(way, row) : std::nullopt;
        for (std::size_t i = 0; i < m_examinations.size() && !m_context.isStopped(); ++i) {
            row.queries = m_examinations[i].queries;
            if (row.reason.empty()) {
                ask(*collider, m_examinations[i], row);
            }
            m_made.rows.push_back(row);
        }
    }

    /// As often as is needed to time it.
    std::optional<SceneCollider> build(const Way &way, ColliderRow &row) const
    {
        std::optional<SceneCollider> collider;
        std::vector<double> milliseconds;
        double seconds = 0.0;
        while (milliseconds.empty() || (seconds < buildSeconds && milliseconds.size() < mostBuilds)) {
            const double begin = threadSeconds();
            auto built =
                SceneCollider::create(m_subject.scene, {way.kind, way.tolerance.value_or(0.0)}, m_context.stop);
            const double took = threadSeconds() - begin;
            if (!built) {
                row.reason = std::format("not possible: {}", built.error());
                return std::nullopt;
            }
            collider.emplace(std::move(*built));
            seconds += took;
            milliseconds.push_back(1e3 * took);
        }
        row.buildMilliseconds = spreadOf(std::move(milliseconds));
        row.bytes = collider->memoryUse();
        return collider;
    }

    void ask(const Collider &collider, const Examination &examination, ColliderRow &row) const
    {
        const std::stop_token &stop = m_context.stop;
        row.survey = survey(collider, examination, m_options.mostOperations, stop);
        const double operations = row.survey.faceTestsMean + 4.0 * row.survey.nodeVisitsMean;
        if (row.survey.asked == 1 && operations > 2.0 * static_cast<double>(m_options.mostOperations)) {
            row.reason = std::format("not tried: a query takes {:.2g} face tests", row.survey.faceTestsMean);
            return;
        }
        const std::vector<double> rounds = nanosecondsOf(collider, examination, row.survey.asked, stop);
        if (!rounds.empty()) {
            row.nanoseconds = spreadOf(rounds);
        }
    }

    const Subject &m_subject;
    const Options &m_options;
    const TrialContext &m_context;
    std::vector<Examination> m_examinations;
    ColliderTrial m_made;
};

}

std::span<const double> trialTolerances()
{
    return tolerances;
}

std::string nameOf(const ColliderRow &row)
{
    const std::string_view kind = colliderNames[static_cast<std::size_t>(row.kind)];
    return row.tolerance ? std::format("{} {}", kind, briefly(*row.tolerance)) : std::string(kind);
}

std::expected<ColliderTrial, std::string> tryColliders(const std::shared_ptr<const Scene> &scene,
                                                       std::span<const Ball> balls, const Options &options,
                                                       const TrialContext &context)
{
    return Subject::of(scene, balls).and_then([&](const Subject &subject) {
        return Trial(subject, options, context).run();
    });
}

}
