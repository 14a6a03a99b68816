#include "core/vehicle/flight_rules.h"

#include "core/mavlink/px4_mode.h"

#include <algorithm>
#include <iterator>

namespace skyseal::vehicle {

namespace {

using TakeOff = FlightRules::TakeOff;

constexpr Act kNone{};
constexpr Act kByCommand{Act::Way::Command};

constexpr Act by(std::string_view mode)
{
    return {Act::Way::Mode, mode};
}

enum class Firmware : std::uint8_t { ArduPilot, Px4, Other };

struct Row
{
    Firmware firmware;
    Frame frame;
    FlightRules rules;
};

/// A copter of ArduPilot holds in BRAKE: in LOITER it would sink while the throttle stick of its transmitter is down, as it is
/// without a pilot. BRAKE holds place and altitude whatever the sticks do, and is what QGroundControl sends to pause it.
constexpr FlightRules kArduCopter{.takeOff = TakeOff::AboveHome,
                                  .takesOffIn = "GUIDED",
                                  .armsForMissionIn = "GUIDED",
                                  .land = by("LAND"),
                                  .returnHome = by("RTL"),
                                  .hold = by("BRAKE"),
                                  .mission = kByCommand};

/// ArduPlane answers MAV_CMD_NAV_TAKEOFF for vertical take-offs only (QuadPlane::do_user_takeoff); the others begin in its
/// mode TAKEOFF or in a mission. It has no mode that lands where the plane is, either.
constexpr FlightRules kArduPlane{.returnHome = by("RTL"), .hold = by("LOITER"), .mission = kByCommand};

constexpr FlightRules kArduVtolPlane{.takeOff = TakeOff::AboveHome,
                                     .takesOffIn = "GUIDED",
                                     .land = by("QLAND"),
                                     .returnHome = by("RTL"),
                                     .hold = by("LOITER"),
                                     .mission = kByCommand};

/// MAV_CMD_MISSION_START would enter the mode before it arms: where arming is denied, the next arming would begin the flight.
constexpr FlightRules kPx4{
    .takeOff = TakeOff::AboveSea, .land = kByCommand, .returnHome = kByCommand, .hold = by("LOITER"), .mission = by("MISSION")};

constexpr FlightRules kPx4OnGround{.flies = false, .returnHome = kByCommand, .hold = by("LOITER"), .mission = by("MISSION")};

constexpr FlightRules kOtherAutopilot{.takeOff = TakeOff::AboveHome,
                                      .startsNeedArmed = false,
                                      .land = kByCommand,
                                      .returnHome = kByCommand,
                                      .hold = kByCommand,
                                      .mission = kByCommand};

constexpr FlightRules kOtherOnGround{.flies = false,
                                     .startsNeedArmed = false,
                                     .land = kByCommand,
                                     .returnHome = kByCommand,
                                     .hold = kByCommand,
                                     .mission = kByCommand};

constexpr Row kTable[] = {
    {Firmware::ArduPilot, Frame::Multirotor, kArduCopter},
    {Firmware::ArduPilot, Frame::Helicopter, kArduCopter},
    {Firmware::ArduPilot, Frame::Plane, kArduPlane},
    {Firmware::ArduPilot, Frame::VtolPlane, kArduVtolPlane},
    {Firmware::ArduPilot, Frame::Rover, {.flies = false, .returnHome = by("RTL"), .hold = by("LOITER"), .mission = kByCommand}},
    {Firmware::ArduPilot,
     Frame::Submarine,
     {.flies = false, .land = by("SURFACE"), .hold = by("POSHOLD"), .mission = kByCommand}},
    {Firmware::ArduPilot, Frame::Tracker, {.flies = false}},
    {Firmware::ArduPilot, Frame::Other, {.takeOff = TakeOff::AboveHome, .mission = kByCommand}},
    {Firmware::Px4, Frame::Multirotor, kPx4},
    {Firmware::Px4, Frame::Helicopter, kPx4},
    {Firmware::Px4, Frame::Plane, kPx4},
    {Firmware::Px4, Frame::VtolPlane, kPx4},
    {Firmware::Px4, Frame::Rover, kPx4OnGround},
    {Firmware::Px4, Frame::Submarine, kPx4OnGround},
    {Firmware::Px4, Frame::Tracker, {.flies = false}},
    {Firmware::Px4, Frame::Other, kPx4},
    {Firmware::Other, Frame::Multirotor, kOtherAutopilot},
    {Firmware::Other, Frame::Helicopter, kOtherAutopilot},
    {Firmware::Other, Frame::Plane, kOtherAutopilot},
    {Firmware::Other, Frame::VtolPlane, kOtherAutopilot},
    {Firmware::Other, Frame::Rover, kOtherOnGround},
    {Firmware::Other, Frame::Submarine, kOtherOnGround},
    {Firmware::Other, Frame::Tracker, kOtherOnGround},
    {Firmware::Other, Frame::Other, kOtherAutopilot},
};

} // namespace

const FlightRules &rulesOf(const VehicleState &state)
{
    const VehicleKind kind{state.type, state.autopilot};
    const Firmware firmware = kind.isArduPilot() ? Firmware::ArduPilot : kind.isPx4() ? Firmware::Px4 : Firmware::Other;
    const Frame frame = frameOf(kind, state.verticalTakeOff);
    const auto row = std::ranges::find_if(kTable,
                                          [&](const Row &one) { return one.firmware == firmware && one.frame == frame; });
    return row != std::end(kTable) ? row->rules : kOtherAutopilot; // the table has all
}

bool armingTakesOff(const VehicleState &state)
{
    const VehicleKind kind{state.type, state.autopilot};
    const std::uint32_t mode = state.customMode;
    if (!rulesOf(state).flies || (state.baseMode & mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED) == 0)
        return false;
    if (kind.isPx4())
        return mode == mavlink::kPx4AutoTakeOff || mode == mavlink::kPx4AutoVtolTakeOff || mode == mavlink::kPx4AutoMission;
    return kind.isArduPilot() && kind.isPlane() && (mode == mavlink::PLANE_MODE_TAKEOFF || mode == mavlink::PLANE_MODE_AUTO);
}

} // namespace skyseal::vehicle
