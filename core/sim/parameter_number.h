// Numbers out of the parameters of a mission item or command, which a ground station sent and which may be anything.
#pragma once

namespace skyseal::sim {

/// Seconds: never negative, never not-a-number.
inline double durationOf(float seconds)
{
    return seconds > 0 ? static_cast<double>(seconds) : 0;
}

/// A whole number within limits.
inline int wholeNumber(float value, int low, int high)
{
    if (!(value >= static_cast<float>(low)))
        return low;
    return value >= static_cast<float>(high) ? high : static_cast<int>(value);
}

} // namespace skyseal::sim
