// The only place of core that asks the operating system for the time. Programs read it once per wake-up and hand the
// value in; the protocol classes never come here.
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
