// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cassert>
#include <functional>
#include <future>
#include <utility>

#include <QObject>

namespace romanesco {

/// One piece of work at a time off the owner's thread, whose result comes back to that. A member of its owner, whose last
/// members it had better be: the end of it waits for the work.
template<typename Result>
class BackgroundTask
{
public:
    explicit BackgroundTask(QObject &owner)
        : m_owner(owner)
    {
    }
    BackgroundTask(const BackgroundTask &) = delete;
    BackgroundTask &operator=(const BackgroundTask &) = delete;

    /// Until what is to be done with the result has been done, or has begun.
    [[nodiscard]] bool isRunning() const { return m_result.valid(); }

    /// done is called on the owner's thread, by its event loop or by finish().
    void start(std::function<Result()> work, std::function<void(Result)> done)
    {
        assert(!isRunning() && "one at a time");
        m_done = std::move(done);
        const unsigned run = ++m_run;
        m_result = std::async(std::launch::async, [this, run, work = std::move(work)] {
            Result result = work();
            QMetaObject::invokeMethod(
                &m_owner,
                [this, run] {
                    if (run == m_run) {
                        finish();
                    }
                },
                Qt::QueuedConnection);
            return result;
        });
    }

    /// Waits for it, where it runs.
    void finish()
    {
        if (isRunning()) {
            const auto done = std::exchange(m_done, {});
            done(m_result.get());
        }
    }

private:
    QObject &m_owner;
    std::function<void(Result)> m_done;
    unsigned m_run = 0;
    std::future<Result> m_result;
};

}
