#include "core/sim/pilot_input.h"

#include <algorithm>
#include <cmath>

namespace skyseal::sim {

namespace {

constexpr std::uint16_t kLow = 1000, kMiddle = 1500, kUntouched = 65535;
constexpr std::uint16_t kFailsafeThrottle = 950; // of a receiver that hears nothing
constexpr double kDeadZone = 0.04;

std::uint16_t pulse(double share) // of the way from 1000 to 2000 µs
{
    return static_cast<std::uint16_t>(std::lround(kLow + 1000 * std::clamp(share, 0.0, 1.0)));
}

double centred(std::uint16_t channel)
{
    const double stick = std::clamp((channel - 1500) / 500.0, -1.0, 1.0);
    return std::abs(stick) < kDeadZone ? 0 : stick;
}

} // namespace

void PilotInput::override(TimePoint now, const Channels &channels)
{
    for (std::size_t i = 0; i < kChannels; ++i) {
        if (channels[i] == 0)
            m_overrides[i] = 0;
        else if (channels[i] != kUntouched)
            m_overrides[i] = std::clamp<std::uint16_t>(channels[i], 800, 2200);
    }
    m_overriddenAt = now;
}

void PilotInput::manual(TimePoint now, const Sticks &sticks)
{
    m_overrides[0] = pulse(0.5 + sticks.roll / 2);
    m_overrides[1] = pulse(0.5 + sticks.pitch / 2);
    m_overrides[2] = pulse(sticks.throttle);
    m_overrides[3] = pulse(0.5 + sticks.yaw / 2);
    m_overriddenAt = now;
}

void PilotInput::expire(TimePoint now, Duration timeout)
{
    if (timeout >= Duration::zero() && overridden() && now - m_overriddenAt > timeout)
        releaseAll();
}

void PilotInput::releaseAll()
{
    m_overrides = {};
}

bool PilotInput::overridden() const
{
    return std::any_of(m_overrides.begin(), m_overrides.end(), [](std::uint16_t channel) { return channel != 0; });
}

PilotInput::Channels PilotInput::channels() const
{
    Channels out{kMiddle, kMiddle, m_flying ? kMiddle : kLow, kMiddle, 1800, kLow, kLow, 1800};
    if (m_fault == RadioFault::LowThrottle)
        out[2] = kFailsafeThrottle;
    for (std::size_t i = 0; i < kChannels; ++i) {
        if (m_overrides[i] != 0)
            out[i] = m_overrides[i];
    }
    return out;
}

Sticks PilotInput::sticks() const
{
    const Channels c = channels();
    return {centred(c[0]), centred(c[1]), centred(c[3]), std::clamp((c[2] - 1000) / 1000.0, 0.0, 1.0)};
}

} // namespace skyseal::sim
