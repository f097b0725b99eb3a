// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "stepmeter.h"

namespace romanesco {

namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

constexpr auto measuredFor = 500ms;

}

void StepMeter::begin()
{
    m_sum = {};
    m_from = Clock::now();
}

void StepMeter::add(Clock::duration taken, const World &world, bool goesOn)
{
    ++m_sum.steps;
    m_sum.taken += taken;
    for (const StepReport &report : world.reports()) {
        m_sum.queries += report.queries;
        m_sum.faceTests += report.cost.faceTests;
    }
    const Seconds gone = Clock::now() - m_from;
    if (gone < measuredFor && goesOn) {
        return;
    }
    const auto queries = static_cast<double>(m_sum.queries);
    const auto steps = static_cast<double>(m_sum.steps);
    const double seconds = Seconds(m_sum.taken).count();
    m_figures.faceTests = queries > 0.0 ? static_cast<double>(m_sum.faceTests) / queries : 0.0;
    m_figures.nanoseconds = queries > 0.0 ? 1e9 * seconds / queries : 0.0;
    m_figures.milliseconds = 1e3 * seconds / steps;
    m_figures.realTimeFactor = goesOn ? steps * world.options().laws.timeStep / gone.count() : 0.0;
    begin();
}

}
