// Keeps keys out of the swap space: the pages in which they lie for longer than a handshake are locked into memory.
//
// Pages are never unlocked one by one, because a page is shared with other keys; the system unlocks them when the heap returns
// them. Secrets on the stack, and those of a handshake, live for at most seconds and are not locked.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace skyseal {

/// Locks the pages that hold these bytes. A system call, thus not for the packet path. Failure has no effect but the report of
/// reportLockFailure(). Thread-safe.
void lockPages(const void *begin, std::size_t size) noexcept;

/// Sets the function to call once, on any thread, if pages could not be locked; at once if that has happened already. `error`:
/// an errno.
void reportLockFailure(void (*report)(int error)) noexcept;

/// Base class of objects with keys as direct members: those made by `new` lie in locked pages.
struct InLockedMemory
{
    static void *operator new(std::size_t size)
    {
        void *const place = ::operator new(size);
        lockPages(place, size);
        return place;
    }
};

/// Moves a secret into locked pages, to be shared.
template<typename T> std::shared_ptr<const T> shareInLockedMemory(T secret)
{
    auto shared = std::make_shared<const T>(std::move(secret));
    lockPages(shared.get(), sizeof(T));
    return shared;
}

} // namespace skyseal
