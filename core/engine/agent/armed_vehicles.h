// The vehicles behind an agent that are armed by their newest heartbeats: a pairing must not be possible in flight. A
// silent vehicle keeps its last state. No I/O and no clock.
#pragma once

#include "core/mavlink/frame.h"

#include <cstdint>
#include <set>
#include <utility>

namespace skyseal::engine {

class ArmedVehicles
{
public:
    /// Takes the heartbeat of an autopilot. Returns true if a vehicle is armed.
    bool note(const mavlink::Frame &heartbeat);
    bool any() const { return !m_armed.empty(); }

private:
    std::set<std::pair<std::uint8_t, std::uint8_t>> m_armed; ///< system and component
};

} // namespace skyseal::engine
