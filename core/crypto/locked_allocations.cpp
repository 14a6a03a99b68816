#include "core/crypto/locked_allocations.h"

#include "core/base/locked_memory.h"

#include <openssl/crypto.h>

#include <cstdlib>

namespace skyseal::crypto {

namespace {

thread_local int t_locking = 0;

void *locked(void *place, std::size_t size)
{
    if (place && t_locking > 0)
        lockPages(place, size);
    return place;
}

void *allocate(std::size_t size, const char *, int)
{
    return locked(std::malloc(size), size);
}

void *reallocate(void *place, std::size_t size, const char *, int)
{
    return locked(std::realloc(place, size), size);
}

void release(void *place, const char *, int)
{
    std::free(place);
}

} // namespace

LockedAllocations::LockedAllocations()
{
    ++t_locking;
}

LockedAllocations::~LockedAllocations()
{
    --t_locking;
}

bool LockedAllocations::install()
{
    return CRYPTO_set_mem_functions(allocate, reallocate, release) == 1;
}

} // namespace skyseal::crypto
