// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace romanesco {

/// Runs jobs on a thread of its own, one at a time, where only the newest matters: a job that is posted takes the place
/// of the one that waits, and the one under way is asked to stop. So the last job posted always runs, and what waits
/// is never more than one.
template<typename Job>
class NewestJob
{
public:
    /// Called on the thread. Must not throw. Once stop is requested, nobody waits for what the job was to find out.
    using Work = std::function<void(Job job, std::stop_token stop)>;

    explicit NewestJob(Work work)
        : m_work(std::move(work))
        , m_thread([this] { run(); })
    {
    }

    /// Drops the job that waits, asks the one under way to stop, and waits for it.
    ~NewestJob()
    {
        std::stop_source underWay;
        {
            const std::lock_guard lock(m_mutex);
            m_isEnding = true;
            underWay = m_underWay;
        }
        m_wake.notify_one();
        underWay.request_stop();
    }

    NewestJob(const NewestJob &) = delete;
    NewestJob &operator=(const NewestJob &) = delete;

    /// From any thread, the work's own included. Does not wait.
    void post(Job job)
    {
        // What the lock guards is only moved and copied: a job may be slow to destroy, and a request to stop runs
        // whatever was registered for it.
        std::optional<Job> dropped(std::move(job));
        std::stop_source underWay;
        {
            const std::lock_guard lock(m_mutex);
            std::swap(m_waiting, dropped);
            underWay = m_underWay;
        }
        m_wake.notify_one();
        underWay.request_stop();
    }

private:
    void run()
    {
        std::unique_lock lock(m_mutex);
        while (true) {
            m_wake.wait(lock, [this] { return m_isEnding || m_waiting; });
            if (m_isEnding) {
                return;
            }
            Job job = std::move(*m_waiting);
            m_waiting.reset();
            m_underWay = std::stop_source();
            const std::stop_token stop = m_underWay.get_token();
            lock.unlock();
            m_work(std::move(job), stop);
            lock.lock();
        }
    }

    Work m_work;
    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::optional<Job> m_waiting;
    std::stop_source m_underWay;
    bool m_isEnding = false;
    /// Last: it starts when all the rest is there and ends before the rest goes.
    std::jthread m_thread;
};

}
