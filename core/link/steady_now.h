// The clocks of the operating system, read only here. The I/O code reads the time once per wake-up and passes it to the
// protocol classes, which never call these functions.
#pragma once

#include "core/base/clock.h"

#include <ctime>

namespace skyseal {

/// Never set back or forward. It counts the time while the machine was suspended, unlike std::chrono::steady_clock: what was
/// sent before is older afterwards.
inline TimePoint steadyNow()
{
#ifdef CLOCK_BOOTTIME
    timespec now{};
    ::clock_gettime(CLOCK_BOOTTIME, &now);
    return TimePoint(std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec));
#else
    return TimePoint(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
#endif
}

inline WallTime wallNow()
{
    return std::chrono::time_point_cast<WallTime::duration>(std::chrono::system_clock::now());
}

} // namespace skyseal
