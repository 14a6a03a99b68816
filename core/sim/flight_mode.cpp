#include "core/sim/flight_mode.h"

#include "core/mavlink/px4_mode.h"

#include <algorithm>

namespace skyseal::sim {

namespace {

using namespace mavlink;
using enum FlightMode;

//                                number                    name         position arming manual throttle
constexpr ModeRow kCopterModes[] = {
    {Stabilize, COPTER_MODE_STABILIZE, "STABILIZE", false, true, true},
    {AltHold, COPTER_MODE_ALT_HOLD, "ALT_HOLD", false, true, true},
    {Auto, COPTER_MODE_AUTO, "AUTO", true, false, false},
    {Guided, COPTER_MODE_GUIDED, "GUIDED", true, true, false},
    {Loiter, COPTER_MODE_LOITER, "LOITER", true, true, true},
    {Rtl, COPTER_MODE_RTL, "RTL", true, false, false},
    {Land, COPTER_MODE_LAND, "LAND", false, false, false},
    {Brake, COPTER_MODE_BRAKE, "BRAKE", true, false, false},
};

// _pre_arm_checks() of ArduPlane/mode.h: of these modes only RTL refuses.
constexpr ModeRow kPlaneModes[] = {
    {Manual, PLANE_MODE_MANUAL, "MANUAL", false, true, true},
    {Circle, PLANE_MODE_CIRCLE, "CIRCLE", false, true, false},
    {Stabilize, PLANE_MODE_STABILIZE, "STABILIZE", false, true, true},
    {FlyByWireA, PLANE_MODE_FLY_BY_WIRE_A, "FBWA", false, true, true},
    {Auto, PLANE_MODE_AUTO, "AUTO", true, true, false},
    {Rtl, PLANE_MODE_RTL, "RTL", true, false, false},
    {Loiter, PLANE_MODE_LOITER, "LOITER", true, true, false},
    {TakeOff, PLANE_MODE_TAKEOFF, "TAKEOFF", true, true, false},
    {Guided, PLANE_MODE_GUIDED, "GUIDED", true, true, false},
};

// requires_position() and allows_arming() of Rover/mode.h.
constexpr ModeRow kRoverModes[] = {
    {Manual, ROVER_MODE_MANUAL, "MANUAL", false, true, false}, {Steering, ROVER_MODE_STEERING, "STEERING", false, true, false},
    {Hold, ROVER_MODE_HOLD, "HOLD", false, true, false},       {Loiter, ROVER_MODE_LOITER, "LOITER", true, true, false},
    {Auto, ROVER_MODE_AUTO, "AUTO", true, true, false},        {Rtl, ROVER_MODE_RTL, "RTL", true, false, false},
    {Guided, ROVER_MODE_GUIDED, "GUIDED", true, true, false},
};

// PX4 does not arm in the modes that land or return (ModeRequirements).
constexpr ModeRow kPx4CopterModes[] = {
    {Guided, kPx4AutoLoiter, "AUTO.LOITER", true, true, false},
    {Manual, kPx4Manual, "MANUAL", false, true, true},
    {AltHold, kPx4AltitudeControl, "ALTCTL", false, true, true},
    {Loiter, kPx4PositionControl, "POSCTL", true, true, true},
    {TakeOff, kPx4AutoTakeOff, "AUTO.TAKEOFF", true, true, false},
    {Auto, kPx4AutoMission, "AUTO.MISSION", true, true, false},
    {Rtl, kPx4AutoRtl, "AUTO.RTL", true, false, false},
    {Land, kPx4AutoLand, "AUTO.LAND", false, false, false},
    {Offboard, kPx4Offboard, "OFFBOARD", true, true, false},
    {Stabilize, kPx4Stabilized, "STABILIZED", false, true, true},
};

constexpr ModeTable kCopter(kCopterModes, Land), kPlane(kPlaneModes, Rtl), kRover(kRoverModes, Hold),
    kPx4Copter(kPx4CopterModes, Guided);

} // namespace

const ModeRow *ModeTable::find(FlightMode mode) const
{
    const auto at = std::find_if(m_rows.begin(), m_rows.end(), [&](const ModeRow &row) { return row.mode == mode; });
    return at == m_rows.end() ? nullptr : &*at;
}

const ModeRow *ModeTable::withNumber(std::uint32_t number) const
{
    const auto at = std::find_if(m_rows.begin(), m_rows.end(), [&](const ModeRow &row) { return row.number == number; });
    return at == m_rows.end() ? nullptr : &*at;
}

const ModeRow &ModeTable::row(FlightMode mode) const
{
    const ModeRow *found = find(mode);
    return found ? *found : m_rows.front();
}

const ModeTable &modeTable(const VehicleType &type)
{
    switch (type.kind) {
    case CraftKind::Copter: return type.isPx4() ? kPx4Copter : kCopter;
    case CraftKind::Plane: return kPlane;
    case CraftKind::Rover: return kRover;
    }
    return kCopter;
}

} // namespace skyseal::sim
