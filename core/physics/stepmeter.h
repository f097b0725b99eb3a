// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <chrono>
#include <cstdint>

#include "world.h"

namespace romanesco {

/// Measures what the steps of a world take, over half a second at a time.
class StepMeter
{
public:
    using Clock = std::chrono::steady_clock;

    struct Figures {
        /// Of each query; 0 where there was none.
        double faceTests = 0.0;
        double nanoseconds = 0.0;
        /// Of each step.
        double milliseconds = 0.0;
        /// Simulated seconds for each that went by; 0 while nothing goes on.
        double realTimeFactor = 0.0;
    };
    /// Of the last half second that is over.
    [[nodiscard]] const Figures &figures() const { return m_figures; }

    /// Steps that follow one another in time begin.
    void begin();
    /// They have ended.
    void end() { m_figures.realTimeFactor = 0.0; }
    void clear() { m_figures = {}; }

    /// After a step; one by itself is told at once.
    void add(Clock::duration taken, const World &world, bool goesOn);

private:
    struct Sum {
        std::uint64_t steps = 0;
        std::uint64_t queries = 0;
        std::uint64_t faceTests = 0;
        Clock::duration taken{0};
    };
    Sum m_sum;
    Clock::time_point m_from;
    Figures m_figures;
};

}
