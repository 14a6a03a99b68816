// Other aircraft, as the ADS-B receiver of a vehicle reports them: as many as SIM_ADSB_COUNT says fly one behind the other on
// a circle of SIM_ADSB_RADIUS around the vehicle's start, SIM_ADSB_ALT above it. Where they are depends on the flight time
// alone.
#pragma once

#include "core/mavlink/messages.h"
#include "core/sim/autopilot.h"

#include <optional>

namespace skyseal::sim {

class AirTraffic
{
public:
    static constexpr double kSpeed = 50; ///< m/s over the ground

    /// `autopilot` must outlive this.
    explicit AirTraffic(const Autopilot &autopilot) : m_autopilot(autopilot) {}

    /// The report of one aircraft, of each in turn; nullopt while there is none.
    std::optional<mavlink::AdsbVehicle> nextReport();

private:
    const Autopilot &m_autopilot;
    int m_turn = 0;
};

} // namespace skyseal::sim
