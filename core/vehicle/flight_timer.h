// Flight time: the seconds armed and off the ground. It is kept after landing and starts again at the next take-off after
// arming. No message of ArduPilot or PX4 that both send has it, so a flight that began before the vehicle was heard counts from
// then, and sawTakeOff() says so.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/enums.h"

#include <cstdint>

namespace skyseal::vehicle {

/// MAV_LANDED_STATE.
enum class LandedState : std::uint8_t {
    Undefined = mavlink::MAV_LANDED_STATE_UNDEFINED,
    OnGround = mavlink::MAV_LANDED_STATE_ON_GROUND,
    InAir = mavlink::MAV_LANDED_STATE_IN_AIR,
    TakeOff = mavlink::MAV_LANDED_STATE_TAKEOFF,
    Landing = mavlink::MAV_LANDED_STATE_LANDING
};

class FlightTimer
{
public:
    /// The autopilot was restarted: the next time in the air is another flight.
    void restart() { *this = {}; }
    void handleLandedState(LandedState state) { m_landed = state; }
    /// Call with every heartbeat and position. Before the vehicle reports a landed state, more than 0.5 m above home counts as
    /// off the ground.
    void update(TimePoint now, bool armed, double altitudeRelative);

    /// Seconds, counting on while in the air.
    double flightTime(TimePoint now) const;
    /// False if this flight had begun before the vehicle was first heard.
    bool sawTakeOff() const { return m_sawTakeOff; }
    bool isFlying() const { return m_flying; }

private:
    bool offGround(double altitudeRelative) const;
    bool onGround(double altitudeRelative) const;

    LandedState m_landed = LandedState::Undefined;
    bool m_armed = false;
    bool m_flying = false;
    bool m_newFlight = true;
    bool m_wasOnGround = false; ///< since the start of this object
    bool m_sawTakeOff = true;
    TimePoint m_since{};
    Duration m_before{};
};

} // namespace skyseal::vehicle
