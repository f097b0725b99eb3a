// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "tests/core/collide/allocations.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

std::atomic<std::size_t> count = 0;
std::atomic<std::size_t> bytes = 0;
/// Until one fails.
thread_local std::size_t left = std::numeric_limits<std::size_t>::max();

/// Before each block: its size, and room that keeps what follows aligned.
constexpr std::size_t header = alignof(std::max_align_t);
static_assert(header >= sizeof(std::size_t));

}

/// The standard's calls the other one; a sanitizer's own would not.
void *operator new(std::size_t size, const std::nothrow_t &) noexcept
{
    void *block = left-- == 0 ? nullptr : std::malloc(header + size);
    if (!block) {
        return nullptr;
    }
    *static_cast<std::size_t *>(block) = size;
    ++count;
    bytes += size;
    return static_cast<char *>(block) + header;
}

void *operator new(std::size_t size)
{
    if (void *memory = operator new(size, std::nothrow)) {
        return memory;
    }
    throw std::bad_alloc();
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

void operator delete(void *memory, const std::nothrow_t &) noexcept
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

void failAllocation(std::size_t after)
{
    left = after;
}

}
