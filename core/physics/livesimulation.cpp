// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "livesimulation.h"

#include <utility>

#include "liverun.h"

namespace romanesco {

namespace {

using namespace std::chrono_literals;
using Clock = LiveSimulation::Clock;

/// Frames are told so often at most.
constexpr auto betweenFrames = 8ms;

}

/// The thread, and what is given to it and taken from it: nobody else touches what it has but for what the mutex guards.
class LiveSimulation::Worker
{
public:
    explicit Worker(std::function<void()> changed)
        : m_changed(std::move(changed))
        , m_frame(std::make_shared<const Frame>())
        , m_thread([this] { run(); })
    {
    }

    ~Worker()
    {
        {
            const std::lock_guard lock(m_mutex);
            m_isEnding = true;
            m_sceneStop.request_stop();
        }
        m_stop.request_stop();
        m_wake.notify_one();
    }

    Worker(const Worker &) = delete;
    Worker &operator=(const Worker &) = delete;

    using Order = std::function<void(LiveRun &)>;

    void give(Order order)
    {
        {
            const std::lock_guard lock(m_mutex);
            m_orders.push_back(std::move(order));
        }
        m_wake.notify_one();
    }

    [[nodiscard]] std::shared_ptr<const Frame> newest() const
    {
        const std::lock_guard lock(m_mutex);
        return m_frame;
    }

    /// Of scenes that come while one is made ready only the newest matters.
    void giveScene(std::shared_ptr<const Scene> scene)
    {
        std::stop_source newest;
        std::stop_source underWay;
        {
            const std::lock_guard lock(m_mutex);
            underWay = std::exchange(m_sceneStop, newest);
            m_orders.push_back([scene = std::move(scene), stop = newest.get_token()](LiveRun &live) {
                if (!stop.stop_requested()) {
                    live.setScene(scene, stop);
                }
            });
        }
        underWay.request_stop();
        m_wake.notify_one();
    }

private:
    [[nodiscard]] bool isCalled() const { return m_isEnding || !m_orders.empty(); }

    void run()
    {
        std::unique_lock lock(m_mutex);
        while (!m_isEnding) {
            if (!m_orders.empty()) {
                const std::vector<Order> orders = std::exchange(m_orders, {});
                lock.unlock();
                for (const Order &order : orders) {
                    order(m_live);
                }
                tell();
                lock.lock();
            } else if (!m_live.isPlaying()) {
                m_wake.wait(lock, [this] { return isCalled(); });
            } else if (Clock::now() < m_live.due()) {
                m_wake.wait_until(lock, m_live.due(), [this] { return isCalled(); });
            } else {
                lock.unlock();
                advance();
                lock.lock();
            }
        }
    }

    void advance()
    {
        m_live.advance();
        if (!m_live.isPlaying() || Clock::now() - m_told >= betweenFrames) {
            tell();
        }
    }

    void tell()
    {
        auto frame = std::make_shared<const Frame>(m_live.frame());
        {
            const std::lock_guard lock(m_mutex);
            m_frame = std::move(frame);
        }
        m_told = Clock::now();
        m_changed();
    }

    std::function<void()> m_changed;

    // ---- Guarded
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    std::vector<Order> m_orders;
    std::stop_source m_sceneStop;
    std::shared_ptr<const Frame> m_frame;
    bool m_isEnding = false;

    /// At the end.
    std::stop_source m_stop;

    // ---- The thread's own
    LiveRun m_live{m_stop.get_token()};
    Clock::time_point m_told;

    /// Last: it starts when all the rest is there.
    std::jthread m_thread;
};

LiveSimulation::LiveSimulation(std::function<void()> changed)
    : m_worker(std::make_unique<Worker>(std::move(changed)))
{
}

LiveSimulation::~LiveSimulation() = default;

std::shared_ptr<const LiveSimulation::Frame> LiveSimulation::newest() const
{
    return m_worker->newest();
}

void LiveSimulation::setScene(std::shared_ptr<const Scene> scene)
{
    m_worker->giveScene(std::move(scene));
}

void LiveSimulation::startScene(std::shared_ptr<const Scene> scene)
{
    m_worker->give([scene = std::move(scene)](LiveRun &live) { live.startScene(scene); });
}

void LiveSimulation::setRules(const World::Options &world)
{
    m_worker->give([world](LiveRun &live) { live.setRules(world); });
}

void LiveSimulation::setCollider(const SceneCollider::Options &collider)
{
    m_worker->give([collider](LiveRun &live) { live.setCollider(collider); });
}

void LiveSimulation::setSpeed(double speed)
{
    m_worker->give([speed](LiveRun &live) { live.setSpeed(speed); });
}

void LiveSimulation::play()
{
    m_worker->give(&LiveRun::play);
}

void LiveSimulation::pause()
{
    m_worker->give(&LiveRun::pause);
}

void LiveSimulation::step()
{
    m_worker->give(&LiveRun::step);
}

void LiveSimulation::reset()
{
    m_worker->give(&LiveRun::reset);
}

void LiveSimulation::drop(std::vector<Ball> balls, unsigned mark, std::optional<ScenePlace> place)
{
    m_worker->give(
        [balls = std::move(balls), mark, place = std::move(place)](LiveRun &live) { live.drop(balls, mark, place); });
}

void LiveSimulation::remove(std::uint64_t number)
{
    m_worker->give([number](LiveRun &live) { live.remove(number); });
}

void LiveSimulation::record(std::function<void(std::expected<Recording, std::string>)> told)
{
    m_worker->give([told = std::move(told)](LiveRun &live) { live.record(told); });
}

void LiveSimulation::replay(Recording recording)
{
    m_worker->give([recording = std::move(recording)](LiveRun &live) { live.replay(recording); });
}

}
