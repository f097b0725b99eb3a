// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

namespace romanesco {

/// e to the x, the same bits on every machine and by every compiler, within two units in the last place; 0 where it is below
/// the least normal number, infinite where it is no number.
[[nodiscard]] double exponential(double x);

}
