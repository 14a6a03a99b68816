// The clocks of the operating system, read only here. The I/O code reads the time once per wake-up and passes it to the
// protocol classes, which never call these functions.
#pragma once

#include "core/base/clock.h"

namespace skyseal {

inline TimePoint steadyNow()
{
    return TimePoint(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now().time_since_epoch()));
}

inline WallTime wallNow()
{
    return std::chrono::time_point_cast<WallTime::duration>(std::chrono::system_clock::now());
}

} // namespace skyseal
