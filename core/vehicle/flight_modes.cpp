#include "core/vehicle/flight_modes.h"

#include "core/base/ascii.h"
#include "core/mavlink/px4_mode.h"

#include <algorithm>
#include <charconv>
#include <span>

namespace skyseal::vehicle {

namespace {

using namespace mavlink;

/// A set of frames, on which a mode can be asked for.
using Frames = std::uint16_t;

constexpr Frames only(Frame frame)
{
    return static_cast<Frames>(1u << static_cast<unsigned>(frame));
}

constexpr Frames kEvery = 0x7fff;
/// The autopilot enters the mode by itself, or by a command of its own: AVOID_ADSB and TERMINATION are answers to dangers, an
/// orbit begins by MAV_CMD_DO_ORBIT. Some autopilots list such modes like the others (AVAILABLE_MODES).
constexpr Frames kByItself = 0;
/// Exists on some vehicles only, which list it.
constexpr Frames kIfListed = 0x8000;
constexpr Frames kMultirotor = only(Frame::Multirotor), kHelicopter = only(Frame::Helicopter), kVtol = only(Frame::VtolPlane);
constexpr Frames kHovering = kMultirotor | kHelicopter | kVtol;
constexpr Frames kFlying = kHovering | only(Frame::Plane) | only(Frame::Other);

struct Mode
{
    std::uint32_t number;
    std::string_view name;
    Frames offered = kEvery;
};

constexpr Mode kCopterModes[] = {{COPTER_MODE_STABILIZE, "STABILIZE"},
                                 {COPTER_MODE_ACRO, "ACRO"},
                                 {COPTER_MODE_ALT_HOLD, "ALT_HOLD"},
                                 {COPTER_MODE_AUTO, "AUTO"},
                                 {COPTER_MODE_GUIDED, "GUIDED"},
                                 {COPTER_MODE_LOITER, "LOITER"},
                                 {COPTER_MODE_RTL, "RTL"},
                                 {COPTER_MODE_CIRCLE, "CIRCLE"},
                                 {COPTER_MODE_LAND, "LAND"},
                                 {COPTER_MODE_DRIFT, "DRIFT"},
                                 {COPTER_MODE_SPORT, "SPORT"},
                                 {COPTER_MODE_FLIP, "FLIP"},
                                 {COPTER_MODE_AUTOTUNE, "AUTOTUNE"},
                                 {COPTER_MODE_POSHOLD, "POSHOLD"},
                                 {COPTER_MODE_BRAKE, "BRAKE"},
                                 {COPTER_MODE_THROW, "THROW"},
                                 {COPTER_MODE_AVOID_ADSB, "AVOID_ADSB", kByItself},
                                 {COPTER_MODE_GUIDED_NOGPS, "GUIDED_NOGPS"},
                                 {COPTER_MODE_SMART_RTL, "SMART_RTL"},
                                 {COPTER_MODE_FLOWHOLD, "FLOWHOLD"},
                                 {COPTER_MODE_FOLLOW, "FOLLOW"},
                                 {COPTER_MODE_ZIGZAG, "ZIGZAG"},
                                 {COPTER_MODE_SYSTEMID, "SYSTEMID"},
                                 {COPTER_MODE_AUTOROTATE, "AUTOROTATE", kHelicopter},
                                 {COPTER_MODE_AUTO_RTL, "AUTO_RTL"},
                                 {COPTER_MODE_TURTLE, "TURTLE", kMultirotor}};

constexpr Mode kPlaneModes[] = {{PLANE_MODE_MANUAL, "MANUAL"},
                                {PLANE_MODE_CIRCLE, "CIRCLE"},
                                {PLANE_MODE_STABILIZE, "STABILIZE"},
                                {PLANE_MODE_TRAINING, "TRAINING"},
                                {PLANE_MODE_ACRO, "ACRO"},
                                {PLANE_MODE_FLY_BY_WIRE_A, "FBWA"},
                                {PLANE_MODE_FLY_BY_WIRE_B, "FBWB"},
                                {PLANE_MODE_CRUISE, "CRUISE"},
                                {PLANE_MODE_AUTOTUNE, "AUTOTUNE"},
                                {PLANE_MODE_AUTO, "AUTO"},
                                {PLANE_MODE_RTL, "RTL"},
                                {PLANE_MODE_LOITER, "LOITER"},
                                {PLANE_MODE_TAKEOFF, "TAKEOFF"},
                                {PLANE_MODE_AVOID_ADSB, "AVOID_ADSB", kByItself},
                                {PLANE_MODE_GUIDED, "GUIDED"},
                                {PLANE_MODE_INITIALIZING, "INITIALISING", kByItself},
                                {PLANE_MODE_QSTABILIZE, "QSTABILIZE", kVtol},
                                {PLANE_MODE_QHOVER, "QHOVER", kVtol},
                                {PLANE_MODE_QLOITER, "QLOITER", kVtol},
                                {PLANE_MODE_QLAND, "QLAND", kVtol},
                                {PLANE_MODE_QRTL, "QRTL", kVtol},
                                {PLANE_MODE_QAUTOTUNE, "QAUTOTUNE", kVtol},
                                {PLANE_MODE_QACRO, "QACRO", kVtol},
                                {PLANE_MODE_THERMAL, "THERMAL"},
                                {PLANE_MODE_LOITER_ALT_QLAND, "LOITERALTQLAND", kVtol},
                                {PLANE_MODE_AUTOLAND, "AUTOLAND"}};

constexpr Mode kRoverModes[] = {{ROVER_MODE_MANUAL, "MANUAL"},     {ROVER_MODE_ACRO, "ACRO"},
                                {ROVER_MODE_STEERING, "STEERING"}, {ROVER_MODE_HOLD, "HOLD"},
                                {ROVER_MODE_LOITER, "LOITER"},     {ROVER_MODE_FOLLOW, "FOLLOW"},
                                {ROVER_MODE_SIMPLE, "SIMPLE"},     {ROVER_MODE_DOCK, "DOCK"},
                                {ROVER_MODE_CIRCLE, "CIRCLE"},     {ROVER_MODE_AUTO, "AUTO"},
                                {ROVER_MODE_RTL, "RTL"},           {ROVER_MODE_SMART_RTL, "SMART_RTL"},
                                {ROVER_MODE_GUIDED, "GUIDED"},     {ROVER_MODE_INITIALIZING, "INITIALISING", kByItself}};

constexpr Mode kSubmarineModes[] = {{SUB_MODE_STABILIZE, "STABILIZE"}, {SUB_MODE_ACRO, "ACRO"},
                                    {SUB_MODE_ALT_HOLD, "ALT_HOLD"},   {SUB_MODE_AUTO, "AUTO"},
                                    {SUB_MODE_GUIDED, "GUIDED"},       {SUB_MODE_CIRCLE, "CIRCLE"},
                                    {SUB_MODE_SURFACE, "SURFACE"},     {SUB_MODE_POSHOLD, "POSHOLD"},
                                    {SUB_MODE_MANUAL, "MANUAL"},       {SUB_MODE_MOTORDETECT, "MOTORDETECT", kByItself},
                                    {SUB_MODE_SURFTRAK, "SURFTRAK"}};

constexpr Mode kTrackerModes[] = {{TRACKER_MODE_MANUAL, "MANUAL"},
                                  {TRACKER_MODE_STOP, "STOP"},
                                  {TRACKER_MODE_SCAN, "SCAN"},
                                  {TRACKER_MODE_SERVO_TEST, "SERVO_TEST"},
                                  {TRACKER_MODE_GUIDED, "GUIDED"},
                                  {TRACKER_MODE_AUTO, "AUTO"},
                                  {TRACKER_MODE_INITIALIZING, "INITIALISING", kByItself}};

constexpr Mode kPx4Modes[] = {{kPx4Manual, "MANUAL"},
                              {kPx4AltitudeControl, "ALTCTL", kFlying},
                              {kPx4PositionControl, "POSCTL"},
                              {kPx4Orbit, "ORBIT", kByItself},
                              {kPx4PositionSlow, "POSITION_SLOW", kHovering},
                              {kPx4AutoReady, "READY", kByItself},
                              {kPx4AutoTakeOff, "TAKEOFF", kFlying},
                              {kPx4AutoLoiter, "LOITER"},
                              {kPx4AutoMission, "MISSION"},
                              {kPx4AutoRtl, "RTL"},
                              {kPx4AutoLand, "LAND", kFlying},
                              {kPx4AutoFollowTarget, "FOLLOWME", kHovering},
                              {kPx4AutoPrecisionLand, "PRECLAND", kHovering},
                              {kPx4AutoVtolTakeOff, "VTOL_TAKEOFF", kVtol},
                              {kPx4External1, "EXTERNAL1", kIfListed},
                              {px4Mode(4, 12), "EXTERNAL2", kIfListed},
                              {px4Mode(4, 13), "EXTERNAL3", kIfListed},
                              {px4Mode(4, 14), "EXTERNAL4", kIfListed},
                              {px4Mode(4, 15), "EXTERNAL5", kIfListed},
                              {px4Mode(4, 16), "EXTERNAL6", kIfListed},
                              {px4Mode(4, 17), "EXTERNAL7", kIfListed},
                              {px4Mode(4, 18), "EXTERNAL8", kIfListed},
                              {kPx4Acro, "ACRO"},
                              {kPx4Offboard, "OFFBOARD"},
                              {kPx4Stabilized, "STABILIZED"},
                              {kPx4Rattitude, "RATTITUDE", kIfListed},
                              {kPx4Termination, "TERMINATION", kByItself},
                              {kPx4AltitudeCruise, "ALTITUDE_CRUISE", kFlying}};

std::span<const Mode> modesOf(VehicleKind kind)
{
    if (kind.isPx4())
        return kPx4Modes;
    if (!kind.isArduPilot())
        return {};
    if (kind.isCopter())
        return kCopterModes;
    if (kind.isPlane())
        return kPlaneModes;
    if (kind.isRover())
        return kRoverModes;
    if (kind.isSubmarine())
        return kSubmarineModes;
    if (kind.type == MAV_TYPE_ANTENNA_TRACKER)
        return kTrackerModes;
    return {};
}

const Mode *findMode(VehicleKind kind, std::uint32_t number)
{
    for (const Mode &mode : modesOf(kind)) {
        if (mode.number == number)
            return &mode;
    }
    return nullptr;
}

bool isSameName(std::string_view name, std::string_view asked)
{
    return std::ranges::equal(name, asked,
                              [](char a, char b) { return asciiLower(a == ' ' ? '_' : a) == asciiLower(b == ' ' ? '_' : b); });
}

} // namespace

bool VehicleKind::isCopter() const
{
    switch (type) {
    case MAV_TYPE_QUADROTOR:
    case MAV_TYPE_COAXIAL:
    case MAV_TYPE_HELICOPTER:
    case MAV_TYPE_HEXAROTOR:
    case MAV_TYPE_OCTOROTOR:
    case MAV_TYPE_TRICOPTER:
    case MAV_TYPE_DODECAROTOR:
    case MAV_TYPE_DECAROTOR:
    case MAV_TYPE_GENERIC_MULTIROTOR: return true;
    default: return false;
    }
}

bool VehicleKind::isPlane() const
{
    return type == MAV_TYPE_FIXED_WING || (type >= MAV_TYPE_VTOL_TAILSITTER_DUOROTOR && type <= MAV_TYPE_VTOL_RESERVED5);
}

bool VehicleKind::isRover() const
{
    return type == MAV_TYPE_GROUND_ROVER || type == MAV_TYPE_SURFACE_BOAT;
}

bool VehicleKind::isSubmarine() const
{
    return type == MAV_TYPE_SUBMARINE;
}

Frame frameOf(VehicleKind kind, bool verticalTakeOff)
{
    if (kind.type == MAV_TYPE_HELICOPTER)
        return Frame::Helicopter;
    if (kind.isCopter())
        return Frame::Multirotor;
    if (kind.isPlane())
        return kind.type != MAV_TYPE_FIXED_WING || verticalTakeOff ? Frame::VtolPlane : Frame::Plane;
    if (kind.isRover())
        return Frame::Rover;
    if (kind.isSubmarine())
        return Frame::Submarine;
    return kind.type == MAV_TYPE_ANTENNA_TRACKER ? Frame::Tracker : Frame::Other;
}

std::string modeName(VehicleKind kind, std::uint8_t baseMode, std::uint32_t customMode, std::span<const OwnMode> own)
{
    if (baseMode & MAV_MODE_FLAG_CUSTOM_MODE_ENABLED) {
        for (const OwnMode &mode : own) {
            if (mode.number == customMode)
                return mode.name;
        }
        if (const Mode *mode = findMode(kind, customMode))
            return std::string(mode->name);
        return "MODE(" + std::to_string(customMode) + ")";
    }
    if (baseMode & MAV_MODE_FLAG_AUTO_ENABLED)
        return "AUTO";
    if (baseMode & MAV_MODE_FLAG_GUIDED_ENABLED)
        return "GUIDED";
    if (baseMode & MAV_MODE_FLAG_STABILIZE_ENABLED)
        return "STABILIZE";
    if (baseMode & MAV_MODE_FLAG_MANUAL_INPUT_ENABLED)
        return "MANUAL";
    return "PREFLIGHT";
}

std::optional<std::uint32_t> modeNumber(VehicleKind kind, std::string_view name, std::span<const OwnMode> own)
{
    for (const OwnMode &mode : own) {
        if (isSameName(mode.name, name))
            return mode.number;
    }
    for (const Mode &mode : modesOf(kind)) {
        if (isSameName(mode.name, name))
            return mode.number;
    }
    if (name.size() > 6 && equalIgnoringCase(name.substr(0, 5), "MODE(") && name.back() == ')') {
        std::uint32_t number = 0;
        const char *end = name.data() + name.size() - 1;
        const auto [stop, error] = std::from_chars(name.data() + 5, end, number);
        if (error == std::errc() && stop == end)
            return number;
    }
    return std::nullopt;
}

std::vector<std::string> modeNames(VehicleKind kind, bool verticalTakeOff, std::span<const OwnMode> own)
{
    std::vector<std::string> out;
    for (const OwnMode &mode : own) {
        const Mode *known = findMode(kind, mode.number);
        if (mode.selectable && !(known && known->offered == kByItself))
            out.push_back(mode.name);
    }
    if (!own.empty())
        return out;
    const Frames frame = only(frameOf(kind, verticalTakeOff));
    for (const Mode &mode : modesOf(kind)) {
        if (mode.offered & frame)
            out.emplace_back(mode.name);
    }
    return out;
}

bool isVerticalMode(VehicleKind kind, std::uint32_t customMode)
{
    const Mode *mode = kind.isArduPilot() && kind.isPlane() ? findMode(kind, customMode) : nullptr;
    return mode && mode->offered == kVtol;
}

} // namespace skyseal::vehicle
