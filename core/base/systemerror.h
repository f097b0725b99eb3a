// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <string>

namespace romanesco {

/// An errno as a phrase that completes "cannot read …: " and "cannot write …: ": "disk full", "permission denied".
[[nodiscard]] std::string systemReason(int number);

}
