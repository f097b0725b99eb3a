// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QByteArray>

#include "core/measure/measurement.h"

namespace romanesco::cli {

/// What was measured, for machines.
[[nodiscard]] QByteArray jsonOf(const Measurement &measurement);

}
