// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "ballasks.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/physics/world.h"

namespace romanesco {

namespace {

constexpr double seconds = 5.0;
/// What is kept at most; balls beyond are not waited for.
constexpr std::size_t mostAsks = 200'000;

/// Keeps all that a search is asked.
class RecordingSearch final : public Search
{
public:
    RecordingSearch(std::unique_ptr<Search> search, std::vector<Ask> &asks)
        : m_search(std::move(search))
        , m_asks(asks)
    {
    }

    void closest(const Query &query, Hit &hit) override
    {
        keep(query);
        m_search->closest(query, hit);
    }

    void sweep(const Sweep &sweep, Touch &touch) override
    {
        keep(sweep);
        m_search->sweep(sweep, touch);
    }

private:
    template<typename Question>
    void keep(Question question)
    {
        question.nodeBudget = askBudget; // not what is left of a step's
        m_asks.push_back({.what = question});
    }

    std::unique_ptr<Search> m_search;
    std::vector<Ask> &m_asks;
};

/// For one thread.
class RecordingCollider final : public Collider
{
public:
    RecordingCollider(std::shared_ptr<const Collider> collider, std::vector<Ask> &asks)
        : m_collider(std::move(collider))
        , m_asks(asks)
    {
    }

    [[nodiscard]] std::unique_ptr<Search> search() const override
    {
        return std::make_unique<RecordingSearch>(m_collider->search(), m_asks);
    }
    [[nodiscard]] std::size_t memoryUse() const override { return m_collider->memoryUse(); }

private:
    std::shared_ptr<const Collider> m_collider;
    std::vector<Ask> &m_asks;
};

bool isAwake(const BallState &ball)
{
    return !ball.isAsleep;
}

}

std::vector<Ask> asksOfBalls(const Surface &surface, std::span<const Ball> balls, std::size_t count,
                             const std::stop_token &stop)
{
    std::vector<Ask> asks;
    Surface recording = surface;
    recording.collider = std::make_shared<const RecordingCollider>(surface.collider, asks);
    World world(std::move(recording), {.threads = 1});
    for (const Ball &ball : balls) {
        world.add(ball);
    }
    const auto steps = static_cast<std::uint64_t>(seconds / world.options().laws.timeStep);
    while (world.stepCount() < steps && asks.size() < mostAsks && std::ranges::any_of(world.balls(), isAwake)) {
        if (stop.stop_requested()) {
            return {};
        }
        world.step();
    }
    std::vector<Ask> chosen;
    for (std::size_t i = 0; i < std::min(count, asks.size()); ++i) {
        chosen.push_back(asks[i * asks.size() / std::min(count, asks.size())]);
    }
    return chosen;
}

}
