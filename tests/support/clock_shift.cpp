// Library for LD_PRELOAD: moves the time of day of a program by CLOCK_SHIFT seconds, CLOCK_SHIFT_AFTER seconds after it first
// reads a clock. The monotonic clocks are unchanged.
#include <cstdlib>
#include <ctime>

#include <dlfcn.h>
#include <sys/time.h>

namespace {

using Gettime = int (*)(clockid_t, timespec *);

Gettime theRealOne()
{
    static const auto kReal = reinterpret_cast<Gettime>(dlsym(RTLD_NEXT, "clock_gettime"));
    return kReal;
}

long numberIn(const char *variable)
{
    const char *text = std::getenv(variable);
    return text ? std::strtol(text, nullptr, 10) : 0;
}

time_t shift()
{
    timespec now{};
    theRealOne()(CLOCK_MONOTONIC, &now);
    static const time_t kStart = now.tv_sec;
    static const long kAfter = numberIn("CLOCK_SHIFT_AFTER"), kBy = numberIn("CLOCK_SHIFT");
    return now.tv_sec - kStart >= kAfter ? kBy : 0;
}

} // namespace

extern "C" int clock_gettime(clockid_t clock, timespec *out) noexcept
{
    const int status = theRealOne()(clock, out);
    if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE))
        out->tv_sec += shift();
    return status;
}

extern "C" int gettimeofday(timeval *out, void *) noexcept
{
    timespec now{};
    const int status = clock_gettime(CLOCK_REALTIME, &now);
    out->tv_sec = now.tv_sec;
    out->tv_usec = now.tv_nsec / 1000;
    return status;
}

extern "C" time_t time(time_t *out) noexcept
{
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    if (out)
        *out = now.tv_sec;
    return now.tv_sec;
}
