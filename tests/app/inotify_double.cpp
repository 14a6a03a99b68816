#include "tests/app/inotify_double.h"

#include <cerrno>
#include <cstdint>

#include <sys/inotify.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace skyseal::test {

Inotify inotifyIs = Inotify::Works;

} // namespace skyseal::test

using skyseal::test::Inotify;
using skyseal::test::inotifyIs;

/// Takes the place of the C library's function, also for Qt.
extern "C" int inotify_add_watch(int descriptor, const char *path, std::uint32_t mask) noexcept
{
    static int number = 1'000'000;
    if (inotifyIs == Inotify::Silent)
        return ++number;
    if (inotifyIs == Inotify::UsedUp) {
        errno = ENOSPC;
        return -1;
    }
    return static_cast<int>(::syscall(SYS_inotify_add_watch, descriptor, path, mask));
}
