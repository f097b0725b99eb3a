// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "core/base/threadteam.h"
#include "probe.h"

namespace romanesco {

/// Those who share the work of a step: the threads of a team, each with a probe of its own; or one probe by itself.
class Crew
{
public:
    /// What is given must outlive it.
    explicit Crew(Probe &alone)
        : m_alone(&alone)
    {
    }
    /// A probe for each thread.
    Crew(ThreadTeam &team, std::span<const std::unique_ptr<Probe>> probes)
        : m_team(&team)
        , m_probes(probes)
    {
    }

    /// work(i, probe) for each i below count, on several threads in any order: none may stand on another's result.
    template<typename Work>
    void forEach(std::size_t count, const Work &work) const
    {
        const auto some = [&](std::size_t first, std::size_t last, Probe &probe) {
            for (std::size_t i = first; i < last; ++i) {
                work(i, probe);
            }
        };
        if (m_team == nullptr) {
            some(0, count, *m_alone);
        } else {
            m_team->run(count, atATime, [&](std::size_t first, std::size_t last, unsigned thread) {
                some(first, last, *m_probes[thread]);
            });
        }
    }

    /// Of the thread that asks.
    [[nodiscard]] Probe &own() const { return m_team == nullptr ? *m_alone : *m_probes.front(); }

private:
    /// Balls that a thread takes at once: some microseconds of work.
    static constexpr std::size_t atATime = 16;

    Probe *m_alone = nullptr;
    ThreadTeam *m_team = nullptr;
    std::span<const std::unique_ptr<Probe>> m_probes;
};

}
