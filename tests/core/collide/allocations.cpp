// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "tests/core/collide/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count = 0;
std::atomic<std::size_t> bytes = 0;

/// Before each block: its size, and room that keeps what follows aligned.
constexpr std::size_t header = alignof(std::max_align_t);
static_assert(header >= sizeof(std::size_t));

}

void *operator new(std::size_t size)
{
    void *block = std::malloc(header + size);
    if (!block) {
        throw std::bad_alloc();
    }
    *static_cast<std::size_t *>(block) = size;
    ++count;
    bytes += size;
    return static_cast<char *>(block) + header;
}

void operator delete(void *memory) noexcept
{
    if (memory) {
        void *block = static_cast<char *>(memory) - header;
        bytes -= *static_cast<std::size_t *>(block);
        std::free(block);
    }
}

void operator delete(void *memory, std::size_t) noexcept
{
    operator delete(memory);
}

namespace romanesco::test {

std::size_t allocationCount()
{
    return count;
}

std::size_t bytesAllocated()
{
    return bytes;
}

}
