// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "dragtolerance.h"

#include <algorithm>
#include <cmath>

namespace romanesco {

namespace {

/// At one step, up or down: what one picture tells of the next is not certain.
constexpr double mostChange = 2.0;
/// Less is no change, lest pictures flicker.
constexpr double leastChange = 1.15;

}

void DragTolerance::finished(double milliseconds)
{
    // The aim is below the budget, as times vary.
    const double wanted = std::sqrt(std::max(milliseconds, 0.0) / (0.75 * budgetMilliseconds));
    const double change = std::clamp(wanted, 1.0 / mostChange, mostChange);
    if (change > leastChange || change < 1.0 / leastChange) {
        m_pixels = std::clamp(m_pixels * change, finest, coarsest);
    }
}

bool DragTolerance::givesUp(double milliseconds)
{
    if (milliseconds <= mostMilliseconds || m_pixels >= coarsest) {
        return false;
    }
    m_pixels = std::min(m_pixels * mostChange, coarsest);
    return true;
}

}
