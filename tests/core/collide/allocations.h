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

/// After so many more, one that this thread asks for fails, once; another call takes its place, and nothing fails any more
/// with the greatest number.
void failAllocation(std::size_t after);

}
