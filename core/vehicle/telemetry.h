// Reads telemetry into a VehicleState: one function per message, found through a table. Each converts wire units into those of
// the state, and values by which a field says "not known" into kUnknown, which replaces a value known before. Values that a
// message lacks keep their last state.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/frame.h"
#include "core/vehicle/batteries.h"
#include "core/vehicle/flight_timer.h"
#include "core/vehicle/vehicle_state.h"

#include <optional>

namespace skyseal::vehicle {

/// Values of one message that are not part of the state, and whether the position changed.
struct TelemetryUpdate
{
    bool positionChanged = false;
    bool verticalTakeOff = false;      ///< EXTENDED_SYS_STATE: it hovers
    bool restarted = false;            ///< the autopilot counts its time from a new start
    std::optional<Position> home;      ///< HOME_POSITION
    std::optional<LandedState> landed; ///< EXTENDED_SYS_STATE
};

class Telemetry
{
public:
    /// Updates the state from a message of the table; ignores others.
    TelemetryUpdate handle(TimePoint now, const mavlink::Frame &frame, VehicleState &state);

private:
    friend struct TelemetryReaders;
    std::uint32_t m_sinceBoot = 0; ///< milliseconds
    Position m_estimate, m_raw;    ///< of GLOBAL_POSITION_INT and GPS_RAW_INT, which stands in while there is no estimate
    bool m_headingKnown = true;    ///< as GLOBAL_POSITION_INT says; VFR_HUD has no value for "not known"
    bool m_checksByHealth = false; ///< PX4 reports passed checks by their health bit alone, see SYS_STATUS
    Batteries m_batteries;
};

} // namespace skyseal::vehicle
