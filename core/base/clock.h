// Time as the protocol classes see it: passed in by the caller, so that a simulated clock can run hours in milliseconds.
// Nothing below core/link asks the operating system for the time.
#pragma once

#include <chrono>
#include <cstdint>

namespace skyseal {

using Duration = std::chrono::nanoseconds;

/// Tag of the monotonic clock. It has no now() on purpose; core/link/steady_now.h provides one to the programs.
struct MonotonicClock
{
    using duration = Duration;
    using rep = duration::rep;
    using period = duration::period;
    static constexpr bool is_steady = true;
};

/// A point in time of the monotonic clock; its zero has no meaning.
using TimePoint = std::chrono::time_point<MonotonicClock, Duration>;

/// Microseconds since 1970-01-01 UTC, for .tlog and MAVLink; never used for a decision of the secure channel.
using WallTime = std::chrono::time_point<std::chrono::system_clock, std::chrono::microseconds>;

inline constexpr TimePoint kNever = TimePoint::max();

inline double seconds(Duration d)
{
    return std::chrono::duration<double>(d).count();
}

} // namespace skyseal
