// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>

#include <QtEnvironmentVariables>

namespace romanesco::test {

/// How many times as much a test does: ROMANESCO_TEST_TIMES, which long programmes set, or 1.
inline int times()
{
    return std::max(qEnvironmentVariableIntValue("ROMANESCO_TEST_TIMES"), 1);
}

}
