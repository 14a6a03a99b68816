// The active flight mode and the change between modes, with the conditions for entering each.
#pragma once

#include "core/sim/flight_mode.h"
#include "core/sim/guided.h"
#include "core/sim/manual_modes.h"
#include "core/sim/mission_runner.h"

namespace skyseal::sim {

class FlightModes
{
public:
    explicit FlightModes(const GeoFrame &world) : m_auto(world) {}

    FlightMode current() const { return m_current; }
    /// Enters a mode. Returns nullptr, or ArduCopter's reason for staying in the present mode.
    const char *enter(FlightMode mode, const Situation &s);
    FlightDemand update(double dt, const Situation &s);

    Guided &guided() { return m_guided; }
    bool takingOff() const { return m_current == FlightMode::Guided && m_guided.takingOff(); }
    MissionRunner &mission() { return m_auto; }
    const MissionRunner &mission() const { return m_auto; }

    /// Target of the present mode, NED; nullopt if it has none.
    std::optional<Vector3> place(const Situation &s) const;

private:
    FlightMode m_current = FlightMode::Stabilize;
    Guided m_guided;
    Loiter m_loiter;
    Brake m_brake;
    Landing m_landing;
    ReturnFlight m_return;
    MissionRunner m_auto;
};

} // namespace skyseal::sim
