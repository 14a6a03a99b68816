// Reads telemetry into a VehicleState: one function per message, found through a table. Each converts wire units into those of
// the state and "invalid" values into kUnknown. Values that a message lacks keep their last state.
#pragma once

#include "core/mavlink/frame.h"
#include "core/vehicle/flight_timer.h"
#include "core/vehicle/vehicle_state.h"

#include <optional>

namespace skyseal::vehicle {

/// Values of one message that are not part of the state, and whether the position changed.
struct TelemetryUpdate
{
    bool positionChanged = false;
    bool restarted = false;            ///< the autopilot counts its time from a new start
    std::optional<Position> home;      ///< HOME_POSITION
    std::optional<LandedState> landed; ///< EXTENDED_SYS_STATE
};

class Telemetry
{
public:
    /// Updates the state from a message of the table; ignores others.
    TelemetryUpdate handle(const mavlink::Frame &frame, VehicleState &state);

private:
    friend struct TelemetryReaders;
    std::uint32_t m_sinceBoot = 0;    ///< milliseconds
    bool m_hasGlobalPosition = false; ///< after GLOBAL_POSITION_INT; until then raw GPS gives the position
};

} // namespace skyseal::vehicle
