// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace romanesco {

/// Threads that share the rounds of a loop, the caller's being one of them. One caller at a time.
class ThreadTeam
{
public:
    /// As many as the machine runs at once where 0 are asked for.
    explicit ThreadTeam(unsigned threads = 0);
    ~ThreadTeam();
    ThreadTeam(const ThreadTeam &) = delete;
    ThreadTeam &operator=(const ThreadTeam &) = delete;

    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(m_threads.size()) + 1; }

    /// The rounds [first, last), by the thread of a number below size(). Must not throw.
    using Work = std::function<void(std::size_t first, std::size_t last, unsigned thread)>;
    /// Works on all rounds from 0 to count, at most so many at a time, and waits for the last. Which thread takes which is by
    /// chance. A loop that one thread does at once wakes no other.
    void run(std::size_t count, std::size_t atATime, const Work &work);

private:
    void serve(unsigned number);
    void takeRounds(unsigned number);

    std::mutex m_mutex;
    std::condition_variable m_wake;
    std::condition_variable m_done;
    const Work *m_work = nullptr;
    std::size_t m_count = 0;
    std::size_t m_atATime = 1;
    std::size_t m_next = 0;
    /// Those that have not seen the loop, or are still in it.
    std::size_t m_busy = 0;
    std::size_t m_loop = 0;
    bool m_isEnding = false;
    std::vector<std::jthread> m_threads;
};

}
