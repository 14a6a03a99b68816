// The active flight mode and the change between modes, with the conditions for entering each.
#pragma once

#include "core/sim/flight_mode.h"
#include "core/sim/guided.h"
#include "core/sim/hold_here.h"
#include "core/sim/manual_modes.h"
#include "core/sim/mission_runner.h"

namespace skyseal::sim {

class FlightModes
{
public:
    FlightModes(const GeoFrame &world, const VehicleType &type)
        : m_table(modeTable(type)), m_current(m_table.rows().front().mode), m_auto(world, type)
    {}

    FlightMode current() const { return m_current; }
    /// Number, name and conditions of the current mode.
    const ModeRow &row() const { return m_table.row(m_current); }
    const ModeTable &table() const { return m_table; }
    /// Enters a mode. Returns nullptr, or ArduCopter's reason for staying in the present mode.
    const char *enter(FlightMode mode, const Situation &s);
    FlightDemand update(double dt, const Situation &s);

    Guided &guided() { return m_guided; }
    bool takingOff() const
    {
        return (m_current == FlightMode::Guided || m_current == FlightMode::TakeOff) && m_guided.takingOff();
    }
    /// Whether the station decides where to fly.
    bool isGuided() const { return m_current == FlightMode::Guided || m_current == FlightMode::Offboard; }
    MissionRunner &mission() { return m_auto; }
    const MissionRunner &mission() const { return m_auto; }

    /// Target of the present mode, NED; nullopt if it has none.
    std::optional<Vector3> place(const Situation &s) const;

private:
    const ModeTable &m_table;
    FlightMode m_current;
    Guided m_guided;
    LoiterMode m_loiter;
    HoldHere m_hold;
    Brake m_brake;
    Landing m_landing;
    ReturnFlight m_return;
    MissionRunner m_auto;
};

} // namespace skyseal::sim
