// The radio control side: eight channels in µs, as a transmitter would give them or as a ground station overrides them.
// Without input the sticks rest at safe positions: centred, the throttle down while the vehicle is on the ground and in
// the middle while it flies.
#pragma once

#include "core/base/clock.h"
#include "core/sim/faults.h"

#include <array>

namespace skyseal::sim {

/// The sticks; roll, pitch and yaw in [-1, 1] (right, forward-is-negative, clockwise), throttle in [0, 1].
struct Sticks
{
    double roll = 0;
    double pitch = 0;
    double yaw = 0;
    double throttle = 0;
};

class PilotInput
{
public:
    static constexpr std::size_t kChannels = 8;
    using Channels = std::array<std::uint16_t, kChannels>;

    /// RC_CHANNELS_OVERRIDE: per channel 65535 leaves it as it was, 0 releases it, anything else is µs.
    void override(TimePoint now, const Channels &channels);
    /// MANUAL_CONTROL: roll, pitch and yaw in [-1, 1], throttle in [0, 1].
    void manual(TimePoint now, const Sticks &sticks);
    /// Releases the overrides that were not renewed for `timeout`; a negative one never expires.
    void expire(TimePoint now, Duration timeout);
    void releaseAll();

    /// Fault of the transmitter; overrides are not affected.
    void setFault(RadioFault fault) { m_fault = fault; }
    /// Whether anybody holds the sticks: a transmitter or a station.
    bool hasSignal() const { return m_fault != RadioFault::NoSignal || overridden(); }

    /// Where the untouched throttle rests: see above.
    void setFlying(bool flying) { m_flying = flying; }

    Channels channels() const;
    Sticks sticks() const;
    bool overridden() const;

private:
    Channels m_overrides{}; ///< 0 = not overridden
    TimePoint m_overriddenAt{};
    bool m_flying = false;
    RadioFault m_fault = RadioFault::None;
};

} // namespace skyseal::sim
