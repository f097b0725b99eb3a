// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "threadteam.h"

#include <algorithm>
#include <cassert>

namespace romanesco {

ThreadTeam::ThreadTeam(unsigned threads)
{
    const unsigned wanted = threads != 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
    for (unsigned number = 1; number < wanted; ++number) {
        m_threads.emplace_back([this, number] { serve(number); });
    }
}

ThreadTeam::~ThreadTeam()
{
    {
        const std::lock_guard lock(m_mutex);
        m_isEnding = true;
    }
    m_wake.notify_all();
}

void ThreadTeam::run(std::size_t count, std::size_t atATime, const Work &work)
{
    assert(atATime > 0 && "rounds are taken some at a time");
    if (count == 0) {
        return;
    }
    if (count <= atATime || m_threads.empty()) {
        work(0, count, 0);
        return;
    }
    {
        const std::lock_guard lock(m_mutex);
        m_work = &work;
        m_count = count;
        m_atATime = atATime;
        m_next = 0;
        m_busy = m_threads.size();
        ++m_loop;
    }
    m_wake.notify_all();
    takeRounds(0);
    std::unique_lock lock(m_mutex);
    m_done.wait(lock, [this] { return m_busy == 0; });
}

void ThreadTeam::takeRounds(unsigned number)
{
    while (true) {
        std::size_t first = 0;
        std::size_t last = 0;
        {
            const std::lock_guard lock(m_mutex);
            first = m_next;
            last = std::min(m_count, first + m_atATime);
            m_next = last;
        }
        if (first == last) {
            return;
        }
        (*m_work)(first, last, number);
    }
}

void ThreadTeam::serve(unsigned number)
{
    std::size_t seen = 0;
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [&] { return m_isEnding || m_loop != seen; });
        if (m_isEnding) {
            return;
        }
        seen = m_loop;
        lock.unlock();
        takeRounds(number);
        lock.lock();
        if (--m_busy == 0) {
            m_done.notify_one();
        }
    }
}

}
