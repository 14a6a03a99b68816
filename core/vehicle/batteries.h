// The batteries of a vehicle, and which of them is "the battery" that the pilot sees.
//
// The autopilot decides: SYS_STATUS describes the battery that it flies on (ArduPilot: the primary one; PX4: the connected
// one with the least charge). A value that SYS_STATUS does not know, such as a voltage beyond 65 V, comes from the
// BATTERY_STATUS with the lowest id of a battery that flies the vehicle (its function is neither avionics nor payload) and
// does not contradict the charge in SYS_STATUS. So no two batteries are ever mixed, and a battery of another use is never
// shown as that of the flight.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/messages.h"
#include "core/vehicle/vehicle_state.h"

#include <cstddef>
#include <vector>

namespace skyseal::vehicle {

class Batteries
{
public:
    /// A battery that is not reported for this long, while the others are, no longer counts.
    static constexpr Duration kKept = std::chrono::seconds(30);
    /// Reports of more batteries are ignored.
    static constexpr std::size_t kMost = 16;

    void handle(TimePoint now, const mavlink::SysStatus &report);
    void handle(TimePoint now, const mavlink::BatteryStatus &report);
    /// Writes the battery and the list of all batteries.
    void show(VehicleState &state) const;

private:
    struct Report
    {
        Battery battery;
        TimePoint heard{};
    };

    void forget(TimePoint now);
    const Battery *flightBattery() const;

    Report m_main;                 ///< SYS_STATUS
    std::vector<Report> m_reports; ///< BATTERY_STATUS, by rising id
};

} // namespace skyseal::vehicle
