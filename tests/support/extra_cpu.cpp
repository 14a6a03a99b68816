// Library for LD_PRELOAD: makes the agent take a share more CPU time than it would, whatever it does with it. The share is a
// double at the beginning of the file EXTRA_CPU, in host byte order, and may change at any time. Other programs are unchanged.
//
// A thread of its own takes the time, in small pieces. Taken in the event loop, at each wake-up or when it is idle, it would
// let more frames arrive until the next wake-up, and an agent that finds more frames at a wake-up needs less for each: at
// 20,000 frames a second a half more would hide itself wholly.
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <thread>

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <unistd.h>

namespace {

constexpr int kPeriodMs = 10;

std::int64_t timeOf(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
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

/// The thread sleeps and wakes in both arms, so that the share is all that tells them apart.
[[noreturn]] void takeShare(const std::atomic<double> &share)
{
    std::int64_t own = 0; ///< what this thread took for the share
    std::int64_t before = timeOf(CLOCK_PROCESS_CPUTIME_ID);
    for (;;) {
        ::poll(nullptr, 0, kPeriodMs);
        const std::int64_t now = timeOf(CLOCK_PROCESS_CPUTIME_ID);
        const std::int64_t begin = timeOf(CLOCK_THREAD_CPUTIME_ID);
        const auto owed = std::int64_t(double(now - before - own) * share.load(std::memory_order_relaxed));
        own = 0;
        while (own < owed)
            own = timeOf(CLOCK_THREAD_CPUTIME_ID) - begin;
        before = now;
    }
}

__attribute__((constructor)) void start()
{
    if (const auto *share = findShare())
        std::thread(takeShare, std::cref(*share)).detach();
}

} // namespace
