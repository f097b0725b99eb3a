// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>

#include "core/measure/measurement.h"

namespace romanesco::cli {

/// What was measured, for people: a table for each set of queries.
[[nodiscard]] std::string tableOf(const Measurement &measurement);

}
