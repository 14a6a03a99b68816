// Locks the memory in which OpenSSL keeps key schedules, whose place only OpenSSL knows.
#pragma once

namespace skyseal::crypto {

/// While an object exists, memory that OpenSSL allocates on this thread is locked (core/base/locked_memory.h).
class LockedAllocations
{
public:
    LockedAllocations();
    ~LockedAllocations();
    LockedAllocations(const LockedAllocations &) = delete;
    LockedAllocations &operator=(const LockedAllocations &) = delete;

    /// Passes OpenSSL its allocator. Call once, before anything else uses OpenSSL: otherwise it keeps its own, and nothing is
    /// locked. Returns whether that succeeded.
    static bool install();
};

} // namespace skyseal::crypto
