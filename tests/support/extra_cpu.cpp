// Library for LD_PRELOAD: makes the agent's event loop take a share more CPU time than it would, whatever it does with it. The
// share is a double at the beginning of the file EXTRA_CPU, in host byte order, and may change at any time. Other programs are
// unchanged.
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/mman.h>
#include <unistd.h>

namespace {

using Wait = int (*)(int, epoll_event *, int, int);

std::int64_t threadTime()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// Null in other programs.
const std::atomic<double> *findShare()
{
    const char *path = std::getenv("EXTRA_CPU");
    if (!path || std::strcmp(program_invocation_short_name, "skyseal-air") != 0)
        return nullptr;
    const int file = ::open(path, O_RDONLY | O_CLOEXEC);
    void *content = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof(double), PROT_READ, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return content == MAP_FAILED ? nullptr : static_cast<const std::atomic<double> *>(content);
}

} // namespace

extern "C" int epoll_wait(int epoll, epoll_event *events, int most, int milliseconds)
{
    static const auto kReal = reinterpret_cast<Wait>(dlsym(RTLD_NEXT, "epoll_wait"));
    static const auto *kShare = findShare();
    thread_local std::int64_t begin = threadTime();
    if (kShare) {
        // Both arms read the clock equally often, so that the share is all that tells them apart.
        const std::int64_t now = threadTime();
        const auto end = now + std::int64_t(double(now - begin) * kShare->load(std::memory_order_relaxed));
        while (threadTime() < end) {}
        begin = threadTime();
    }
    return kReal(epoll, events, most, milliseconds);
}
