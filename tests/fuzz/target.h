// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <cstdint>

/// The entry point that libFuzzer calls. Returns 0, or -1 for a text that is not worth mutating; a fault shows as an
/// assertion or a sanitizer's report.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size);
