#include "core/base/locked_memory.h"

#include <atomic>
#include <cerrno>
#include <cstdint>

#include <sys/mman.h>
#include <unistd.h>

namespace skyseal {

namespace {

std::atomic<int> g_firstError{0};
std::atomic<void (*)(int)> g_report{nullptr};

void reportOnce(int error)
{
    if (const auto report = g_report.exchange(nullptr))
        report(error);
}

} // namespace

void lockPages(const void *begin, std::size_t size) noexcept
{
    static const auto pageSize = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
    const std::uintptr_t offset = reinterpret_cast<std::uintptr_t>(begin) % pageSize;
    // Not sodium_mlock(): its counterpart would also unlock the other keys of the page.
    if (::mlock(static_cast<const std::uint8_t *>(begin) - offset, size + offset) == 0)
        return;
    int none = 0;
    if (const int error = errno; g_firstError.compare_exchange_strong(none, error))
        reportOnce(error);
}

void reportLockFailure(void (*report)(int error)) noexcept
{
    g_report = report;
    if (const int error = g_firstError)
        reportOnce(error);
}

} // namespace skyseal
