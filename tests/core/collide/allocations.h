// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>

/// What the program's operators new and delete have done so far: in the test programs that link allocations.cpp.
namespace romanesco::test {

/// How often memory was asked for.
std::size_t allocationCount();

/// Bytes asked for and not given back.
std::size_t bytesAllocated();

}
