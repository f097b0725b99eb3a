// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string_view>

#include "fdosyntax.h"

namespace romanesco {

/// Reads a whole .fdo text. Each line is read by itself: a bad one gets one error, and reading goes on at the next.
/// One pass, no recursion; cost linear in the text.
[[nodiscard]] FdoSyntax parseFdo(std::string_view text);

}
