// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>

#include "measurement.h"

namespace romanesco {

/// What was measured, as a page of HTML that needs nothing else: tables, and plots of error against cost. It is XML, too.
[[nodiscard]] std::string pageOf(const Measurement &measurement);

}
