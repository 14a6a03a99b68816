// The mode that flies, and the switch between modes: which may be entered when, and who takes over.
#pragma once

#include "core/sim/flight_mode.h"
#include "core/sim/guided.h"
#include "core/sim/manual_modes.h"
#include "core/sim/mission_runner.h"

namespace skyseal::sim {

class FlightModes
{
public:
    explicit FlightModes(const LocalFrame &world) : m_auto(world) {}

    FlightMode current() const { return m_current; }
    /// Enters a mode; nullptr, or the reason in ArduCopter's words why it stays in the present one.
    const char *enter(FlightMode mode, const Situation &s);
    FlightDemand update(double dt, const Situation &s);

    Guided &guided() { return m_guided; }
    bool takingOff() const { return m_current == FlightMode::Guided && m_guided.takingOff(); }
    MissionRunner &mission() { return m_auto; }
    const MissionRunner &mission() const { return m_auto; }

    /// Where the present mode is heading for, NED; nullopt where that means nothing.
    std::optional<Vector3> place(const Situation &s) const;

private:
    FlightMode m_current = FlightMode::Stabilize;
    Guided m_guided;
    Loiter m_loiter;
    Brake m_brake;
    Landing m_landing;
    ReturnToLaunch m_return;
    MissionRunner m_auto;
};

} // namespace skyseal::sim
