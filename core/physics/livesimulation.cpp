// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "livesimulation.h"

#include <algorithm>
#include <utility>

namespace romanesco {

namespace {

using namespace std::chrono_literals;
using Clock = LiveSimulation::Clock;
using Seconds = std::chrono::duration<double>;

/// Frames are told so often at most.
constexpr auto betweenFrames = 8ms;
/// What is behind by more is not caught up with.
constexpr auto mostDebt = 50ms;

}

/// What the thread has; nobody else touches it but for what the mutex guards.
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

    using Order = std::function<void(Worker &)>;

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
            m_orders.push_back([scene = std::move(scene), stop = newest.get_token()](Worker &worker) {
                if (!stop.stop_requested()) {
                    worker.setScene(scene, stop);
                }
            });
        }
        underWay.request_stop();
        m_wake.notify_one();
    }

    // ---- Orders, on the thread

    void setScene(const std::shared_ptr<const Scene> &scene, const std::stop_token &stop)
    {
        m_scene = scene;
        m_replay.reset();
        if (!m_scene) {
            pause();
        } else if (m_simulation) {
            m_remark.clear();
            if (const auto set = m_simulation->setScene(m_scene, stop); !set && !stop.stop_requested()) {
                say(set.error());
            }
        }
    }

    void startScene(std::shared_ptr<const Scene> scene)
    {
        m_scene = std::move(scene);
        reset();
    }

    void setRules(const World::Options &world)
    {
        m_world = world;
        m_replay.reset();
        if (m_simulation) {
            apply(world);
        }
    }

    void setCollider(const SceneCollider::Options &collider)
    {
        m_replay.reset();
        if (m_simulation && !apply(collider)) {
            return;
        }
        m_collider = collider;
    }

    void setSpeed(double speed)
    {
        m_speed = speed;
        m_due = Clock::now();
    }

    void play()
    {
        m_isPlaying = start();
        m_due = Clock::now();
        m_meter.begin();
    }

    void pause()
    {
        m_isPlaying = false;
        m_meter.end();
    }

    void step()
    {
        pause();
        if (start()) {
            stepOnce();
        }
    }

    void reset()
    {
        pause();
        m_simulation.reset();
        m_replay.reset();
        m_remark.clear();
        m_numbers.clear();
        m_marks.clear();
        m_meter.clear();
    }

    void drop(const std::vector<Ball> &balls, unsigned mark, const std::optional<ScenePlace> &place)
    {
        m_replay.reset();
        if (!start()) {
            return;
        }
        for (const Ball &ball : balls) {
            if (apply(Recording::Drop{ball, place})) {
                add(mark);
            }
        }
    }

    void remove(std::uint64_t number)
    {
        const auto found = std::ranges::find(m_numbers, number);
        if (found == m_numbers.end()) {
            return;
        }
        m_replay.reset();
        const auto at = found - m_numbers.begin();
        if (apply(Recording::Removal{static_cast<std::size_t>(at)})) {
            forget(at);
        }
    }

    void record(const std::function<void(std::expected<Recording, std::string>)> &told)
    {
        if (!start()) {
            told(std::unexpected(m_remark));
        } else if (!m_simulation->isRecorded()) {
            told(std::unexpected("The scene was edited while balls moved. Reset, and what follows can be recorded."));
        } else {
            told(m_simulation->recording());
        }
    }

    void replay(Recording recording)
    {
        reset();
        const World::Options world = std::exchange(m_world, recording.world);
        const SceneCollider::Options collider = std::exchange(m_collider, recording.collider);
        m_isPlaying = start();
        m_world = world;
        m_collider = collider;
        if (!m_isPlaying) {
            return;
        }
        if (m_simulation->world().stateHash() != recording.startHash) {
            reset();
            say("The balls of this scene are not those of the recording.");
            return;
        }
        m_replay.emplace(Replay{std::move(recording)});
        m_due = Clock::now();
        m_meter.begin();
    }

private:
    struct Replay {
        Recording recording;
        std::size_t next = 0;
    };

    // ---- The thread

    [[nodiscard]] bool isCalled() const { return m_isEnding || !m_orders.empty(); }

    void run()
    {
        std::unique_lock lock(m_mutex);
        while (!m_isEnding) {
            if (!m_orders.empty()) {
                const std::vector<Order> orders = std::exchange(m_orders, {});
                lock.unlock();
                for (const Order &order : orders) {
                    order(*this);
                }
                tell();
                lock.lock();
            } else if (!m_isPlaying) {
                m_wake.wait(lock, [this] { return isCalled(); });
            } else if (Clock::now() < m_due) {
                m_wake.wait_until(lock, m_due, [this] { return isCalled(); });
            } else {
                lock.unlock();
                advance();
                lock.lock();
            }
        }
    }

    /// One step that is due.
    void advance()
    {
        const auto way = std::chrono::duration_cast<Clock::duration>(Seconds(wayOfStep()));
        if (Clock::now() - m_due > mostDebt) {
            m_due = Clock::now();
        }
        followReplay();
        if (!m_isPlaying) {
            tell();
            return;
        }
        stepOnce();
        m_due += way;
        if (Clock::now() - m_told >= betweenFrames) {
            tell();
        }
    }

    void followReplay()
    {
        if (!m_replay) {
            return;
        }
        const Recording &recording = m_replay->recording;
        const std::uint64_t step = m_simulation->world().stepCount();
        for (; m_replay->next < recording.inputs.size() && recording.inputs[m_replay->next].step == step;
             ++m_replay->next) {
            const Recording::Input &input = recording.inputs[m_replay->next];
            applyReplayed(input);
        }
        if (step >= recording.steps) {
            say(m_simulation->world().stateHash() == recording.endHash
                    ? "The recording came to the same state as when it was made."
                    : "The recording came to another state than when it was made.");
            m_replay.reset();
            pause();
        }
    }

    void applyReplayed(const Recording::Input &input)
    {
        if (const auto applied = m_simulation->apply(input, m_stop.get_token()); !applied) {
            say(applied.error());
            return;
        }
        if (std::holds_alternative<Recording::Drop>(input.what)) {
            add(0);
        } else if (const auto *removal = std::get_if<Recording::Removal>(&input.what)) {
            forget(static_cast<std::ptrdiff_t>(removal->ball));
        }
    }

    void add(unsigned mark)
    {
        m_numbers.push_back(m_nextNumber++);
        m_marks.push_back(mark);
    }

    void forget(std::ptrdiff_t at)
    {
        m_numbers.erase(m_numbers.begin() + at);
        m_marks.erase(m_marks.begin() + at);
    }

    /// Whether there is a simulation, now at the latest.
    bool start()
    {
        if (!m_scene) {
            say("There is no scene yet.");
            return false;
        }
        if (m_simulation) {
            return true;
        }
        auto made = Simulation::start(m_scene, m_world, m_collider, m_stop.get_token());
        if (!made) {
            say(made.error());
            return false;
        }
        m_simulation.emplace(std::move(*made));
        m_seconds = 0.0;
        m_remark.clear();
        m_nextNumber = 0;
        m_ownBalls = m_simulation->world().balls().size();
        for (std::size_t i = 0; i < m_ownBalls; ++i) {
            add(0);
        }
        return true;
    }

    template<typename What>
    bool apply(const What &what)
    {
        m_remark.clear();
        const auto applied = m_simulation->apply({0, what}, m_stop.get_token());
        if (!applied) {
            say(applied.error());
        }
        return applied.has_value();
    }

    void stepOnce()
    {
        const Clock::time_point begun = Clock::now();
        m_simulation->step();
        m_seconds += m_simulation->world().options().laws.timeStep;
        m_meter.add(Clock::now() - begun, m_simulation->world(), m_isPlaying);
    }

    // ---- What is told

    void say(std::string words) { m_remark = std::move(words); }

    [[nodiscard]] double wayOfStep() const { return m_simulation->world().options().laws.timeStep / m_speed; }

    void tell()
    {
        Frame frame;
        frame.isStarted = m_simulation.has_value();
        frame.isPlaying = m_isPlaying;
        frame.isReplaying = m_replay.has_value();
        frame.figures = m_meter.figures();
        frame.remark = m_remark;
        if (m_simulation) {
            const World &world = m_simulation->world();
            frame.isRecorded = m_simulation->isRecorded();
            frame.stepCount = world.stepCount();
            frame.seconds = m_seconds;
            frame.due = m_due;
            frame.way = Seconds(m_isPlaying ? wayOfStep() : 0.0);
            frame.energy = m_simulation->energy();
            frame.lostSteps = world.lostSteps();
            for (std::uint32_t place = 0; place < world.placeCount(); ++place) {
                frame.places.push_back({m_simulation->places().surroundings(place), world.surface(place)});
            }
            frame.ownBalls = m_ownBalls;
            frame.balls.reserve(world.balls().size());
            for (std::size_t i = 0; i < world.balls().size(); ++i) {
                const BallState &ball = world.balls()[i];
                const unsigned contacts = world.reports()[i].contacts;
                frame.contacts += contacts;
                frame.balls.push_back({m_numbers[i], m_marks[i], m_simulation->before()[i], ball.position,
                                       ball.velocity, ball.radius, ball.restitution, contacts, ball.isAsleep,
                                       ball.place});
            }
        }
        {
            const std::lock_guard lock(m_mutex);
            m_frame = std::make_shared<const Frame>(std::move(frame));
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
    std::shared_ptr<const Scene> m_scene;
    World::Options m_world;
    SceneCollider::Options m_collider;
    double m_speed = 1.0;
    bool m_isPlaying = false;
    std::optional<Simulation> m_simulation;
    /// Of it.
    double m_seconds = 0.0;
    std::optional<Replay> m_replay;
    std::string m_remark;
    /// Beside the balls.
    std::vector<std::uint64_t> m_numbers;
    std::vector<unsigned> m_marks;
    std::uint64_t m_nextNumber = 0;
    std::size_t m_ownBalls = 0;
    Clock::time_point m_due;
    Clock::time_point m_told;

    StepMeter m_meter;

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
    m_worker->give([scene = std::move(scene)](Worker &worker) { worker.startScene(scene); });
}

void LiveSimulation::setRules(const World::Options &world)
{
    m_worker->give([world](Worker &worker) { worker.setRules(world); });
}

void LiveSimulation::setCollider(const SceneCollider::Options &collider)
{
    m_worker->give([collider](Worker &worker) { worker.setCollider(collider); });
}

void LiveSimulation::setSpeed(double speed)
{
    m_worker->give([speed](Worker &worker) { worker.setSpeed(speed); });
}

void LiveSimulation::play()
{
    m_worker->give(&Worker::play);
}

void LiveSimulation::pause()
{
    m_worker->give(&Worker::pause);
}

void LiveSimulation::step()
{
    m_worker->give(&Worker::step);
}

void LiveSimulation::reset()
{
    m_worker->give(&Worker::reset);
}

void LiveSimulation::drop(std::vector<Ball> balls, unsigned mark, std::optional<ScenePlace> place)
{
    m_worker->give([balls = std::move(balls), mark, place = std::move(place)](Worker &worker) {
        worker.drop(balls, mark, place);
    });
}

void LiveSimulation::remove(std::uint64_t number)
{
    m_worker->give([number](Worker &worker) { worker.remove(number); });
}

void LiveSimulation::record(std::function<void(std::expected<Recording, std::string>)> told)
{
    m_worker->give([told = std::move(told)](Worker &worker) { worker.record(told); });
}

void LiveSimulation::replay(Recording recording)
{
    m_worker->give([recording = std::move(recording)](Worker &worker) { worker.replay(recording); });
}

}
