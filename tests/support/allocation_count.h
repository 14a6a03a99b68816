// Counts the allocations of a program: replaces operator new. Include it in one source file of a program that has a single test
// class (ALONE).
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace skyseal::test {

/// Since the program began, of all threads: QtTest has one of its own.
inline std::atomic<std::uint64_t> allocations = 0, released = 0;

} // namespace skyseal::test

void *operator new(std::size_t size)
{
    ++skyseal::test::allocations;
    if (void *memory = std::malloc(size ? size : 1))
        return memory;
    throw std::bad_alloc();
}

void operator delete(void *memory) noexcept
{
    skyseal::test::released += memory != nullptr;
    std::free(memory);
}

void operator delete(void *memory, std::size_t) noexcept
{
    operator delete(memory);
}
