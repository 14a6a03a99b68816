// Reads telemetry into a VehicleState: one small function per message, found through a table, each turning wire units into
// the state's and "invalid" values into unknown. What a message does not know leaves the state as it is.
#pragma once

#include "core/mavlink/frame.h"
#include "core/vehicle/flight_timer.h"
#include "core/vehicle/vehicle_state.h"

#include <cstdint>
#include <optional>

namespace skyseal::vehicle {

/// What messages tell beyond the values of the state.
struct TelemetryNews
{
    bool positionChanged = false;
    std::optional<Position> home;                ///< HOME_POSITION
    std::optional<LandedState> landed;           ///< EXTENDED_SYS_STATE
    std::optional<std::uint16_t> missionCurrent; ///< MISSION_CURRENT
    struct Target
    {
        std::int32_t latitude = 0, longitude = 0;
    };
    std::optional<Target> target; ///< POSITION_TARGET_GLOBAL_INT, degrees × 1e7
};

class Telemetry
{
public:
    /// Takes what is known of this message; nothing happens for others.
    TelemetryNews handle(const mavlink::Frame &frame, VehicleState &state);

private:
    friend struct TelemetryReaders;
    bool m_hasGlobalPosition = false; ///< GLOBAL_POSITION_INT came, so that raw GPS is no longer taken for the position
};

} // namespace skyseal::vehicle
