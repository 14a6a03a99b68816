#include "core/vehicle/command_plan.h"

#include "core/mavlink/force_arm.h"
#include "core/vehicle/flight_modes.h"
#include "core/vehicle/flight_rules.h"
#include "core/vehicle/message_io.h"
#include "core/vehicle/reasons.h"

#include <cmath>

namespace skyseal::vehicle {

namespace {

using Plan = Result<CommandPlan, Reason>;

/// Parameter 1 of MAV_CMD_DO_CHANGE_SPEED.
constexpr float kAirSpeed = mavlink::SPEED_TYPE_AIRSPEED, kGroundSpeed = mavlink::SPEED_TYPE_GROUNDSPEED;
/// Of SET_POSITION_TARGET_GLOBAL_INT: only the position counts.
constexpr std::uint16_t kPositionOnly = mavlink::POSITION_TARGET_TYPEMASK_VX_IGNORE
    | mavlink::POSITION_TARGET_TYPEMASK_VY_IGNORE | mavlink::POSITION_TARGET_TYPEMASK_VZ_IGNORE
    | mavlink::POSITION_TARGET_TYPEMASK_AX_IGNORE | mavlink::POSITION_TARGET_TYPEMASK_AY_IGNORE
    | mavlink::POSITION_TARGET_TYPEMASK_AZ_IGNORE | mavlink::POSITION_TARGET_TYPEMASK_YAW_IGNORE
    | mavlink::POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE;

tl::unexpected<Reason> refuse(Reason reason)
{
    return tl::make_unexpected(std::move(reason));
}

CommandOrder order(std::uint16_t command, float p1 = 0, float p2 = 0, float p3 = 0, float p4 = 0, float p5 = 0, float p6 = 0,
                   float p7 = 0)
{
    return {command, {p1, p2, p3, p4, p5, p6, p7}};
}

Plan plan(CommandOrder command, Effect effect = {})
{
    return CommandPlan{{command}, std::move(effect)};
}

std::int32_t degreesE7(double degrees)
{
    return static_cast<std::int32_t>(std::llround(degrees * 1e7));
}

/// Makes plans for one kind of vehicle in one state.
class Planner
{
public:
    Planner(const VehicleState &state, const Addressing &addressing)
        : m_state(state), m_addressing(addressing), m_rules(rulesOf(state)), m_kind{state.type, state.autopilot}
    {}

    Plan operator()(const Arm &arm) const
    {
        const float force = m_kind.isArduPilot() ? mavlink::kForceArmArduPilot : mavlink::kForceArmDisarm;
        return plan(order(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 1, arm.force ? force : 0), ArmedIs{true});
    }

    Plan operator()(const Disarm &disarm) const
    {
        if (m_state.inAir && m_rules.flies && !disarm.force)
            return refuse(reasons::kDisarmInAir);
        return plan(order(mavlink::MAV_CMD_COMPONENT_ARM_DISARM, 0, disarm.force ? mavlink::kForceArmDisarm : 0),
                    ArmedIs{false});
    }

    Plan operator()(const SetMode &mode) const
    {
        const auto number = modeNumber(m_kind, mode.mode, m_state.ownModes);
        if (number)
            return setMode(*number);
        if (m_state.modes.empty())
            return refuse(reasons::kModesUnknown);
        std::string names;
        for (const std::string &name : m_state.modes)
            names += (names.empty() ? "" : ", ") + name;
        return refuse(reasons::kNoSuchMode(mode.mode, names));
    }

    Plan operator()(const TakeOff &takeOff) const
    {
        if (!(takeOff.altitude > 0))
            return refuse(reasons::kTakeOffTooLow);
        if (m_rules.takeOff == FlightRules::TakeOff::None)
            return refuse(m_rules.flies ? reasons::kNoVerticalTakeOff : reasons::kDoesNotFly);
        double altitude = takeOff.altitude;
        if (m_rules.takeOff == FlightRules::TakeOff::AboveSea) {
            const double ground = m_state.home.known() ? m_state.home.altitude : m_state.position.altitude;
            if (std::isnan(ground))
                return refuse(reasons::kTakeOffNeedsPosition);
            altitude += ground;
        }
        if (!isIn(m_rules.takesOffIn))
            return takeOff.prepare ? enter(m_rules.takesOffIn, takeOff) : refuse(reasons::kTakeOffNeedsGuided(m_state.mode));
        if (m_rules.startsNeedArmed && !m_state.armed)
            return takeOff.prepare ? arm(takeOff) : refuse(reasons::kTakeOffNeedsArmed);
        CommandOrder out = order(mavlink::MAV_CMD_NAV_TAKEOFF);
        out.parameters[6] = static_cast<float>(altitude);
        if (m_kind.isPx4())
            out.parameters[3] = out.parameters[4] = out.parameters[5] = std::nanf(""); // current position and heading
        return plan(out, InAir{});
    }

    Plan operator()(const Land &) const
    {
        if (m_rules.land.way != Act::Way::Command)
            return byMode(m_rules.land, m_kind.isPlane() ? reasons::kNoVerticalLanding : reasons::kNoModeToLand);
        CommandOrder out = order(mavlink::MAV_CMD_NAV_LAND);
        if (m_kind.isPx4())
            out.parameters[3] = out.parameters[4] = out.parameters[5] = std::nanf("");
        return plan(out);
    }

    Plan operator()(const ReturnToLaunch &) const
    {
        if (m_rules.returnHome.way != Act::Way::Command)
            return byMode(m_rules.returnHome, reasons::kNoModeToReturn);
        return plan(order(mavlink::MAV_CMD_NAV_RETURN_TO_LAUNCH));
    }

    Plan operator()(const GoTo &place) const
    {
        if (!isPlace(place.latitude, place.longitude, place.altitudeRelative))
            return refuse(reasons::kNotOnGlobe);
        const bool guided = m_kind.isArduPilot() && isIn("GUIDED");
        if (m_kind.isArduPilot() && !guided && !place.changeMode)
            return refuse(reasons::kGoToNeedsGuided(m_state.mode));
        auto reposition = orderAt(mavlink::MAV_CMD_DO_REPOSITION, place.latitude, place.longitude, place.altitudeRelative);
        if (!reposition)
            return refuse(reasons::kGoToNeedsHome);
        reposition->parameters[0] = -1; // the present speed
        if (m_kind.isPx4() || (m_kind.isArduPilot() && !guided))
            reposition->parameters[1] = mavlink::MAV_DO_REPOSITION_FLAGS_CHANGE_MODE;
        reposition->parameters[3] = std::nanf(""); // the vehicle chooses the heading
        CommandPlan out{{*reposition}, {}};
        // ArduCopter and Rover know DO_REPOSITION since 4.1. Before, a target in GUIDED does the same.
        const auto number = m_kind.isArduPilot() ? modeNumber(m_kind, "GUIDED") : std::nullopt;
        if (number) {
            RepeatedMessage target{positionTarget(place), false};
            if (!guided)
                target.mode = NeededMode{*number, "GUIDED", modeRequest(*number)};
            out.alternatives.push_back(std::move(target));
            out.effect = TargetIs{reposition->x, reposition->y};
        }
        return out;
    }

    Plan operator()(const ChangeAltitude &change) const
    {
        if (!std::isfinite(change.altitudeRelative))
            return refuse(reasons::kAltitudeNoNumber);
        if (!m_rules.flies)
            return refuse(reasons::kDoesNotFly);
        if (!m_kind.isPx4()) {
            if (!m_state.position.known())
                return refuse(reasons::kAltitudeNeedsPosition);
            return (*this)(
                GoTo{m_state.position.latitude, m_state.position.longitude, change.altitudeRelative, change.changeMode});
        }
        if (std::isnan(homeAltitude()))
            return refuse(reasons::kAltitudeNeedsHome);
        CommandOrder out = order(mavlink::MAV_CMD_DO_REPOSITION, -1, mavlink::MAV_DO_REPOSITION_FLAGS_CHANGE_MODE);
        out.parameters[3] = out.parameters[4] = out.parameters[5] = std::nanf(
            ""); // keeps heading and place (navigator_main.cpp)
        out.parameters[6] = static_cast<float>(change.altitudeRelative + homeAltitude());
        return plan(out);
    }

    Plan operator()(const Loiter &) const
    {
        if (m_rules.hold.way != Act::Way::Command)
            return byMode(m_rules.hold, reasons::kNoModeToLoiter);
        return plan(order(mavlink::MAV_CMD_NAV_LOITER_UNLIM));
    }

    Plan operator()(const PointAt &place) const
    {
        if (!isPlace(place.latitude, place.longitude, place.altitudeRelative))
            return refuse(reasons::kNotOnGlobe);
        auto point = orderAt(mavlink::MAV_CMD_DO_SET_ROI_LOCATION, place.latitude, place.longitude, place.altitudeRelative);
        if (!point)
            return refuse(reasons::kPointNeedsHome);
        CommandPlan out{{*point}, {}};
        point->command = mavlink::MAV_CMD_DO_SET_ROI; // of older ArduPilot
        point->parameters[0] = mavlink::MAV_ROI_LOCATION;
        out.alternatives.push_back(*point);
        return out;
    }

    Plan operator()(const StopPointing &) const
    {
        // Older ArduPilot ends it by a place of zeros.
        return CommandPlan{{order(mavlink::MAV_CMD_DO_SET_ROI_NONE), order(mavlink::MAV_CMD_DO_SET_ROI)}, {}};
    }

    Plan operator()(const SetHome &home) const
    {
        if (!isPlace(home.latitude, home.longitude, 0))
            return refuse(reasons::kNotOnGlobe);
        if (std::isnan(homeAltitude()))
            return refuse(reasons::kHomeNeedsHome);
        CommandOrder out = order(mavlink::MAV_CMD_DO_SET_HOME);
        out.asInt = true;
        out.frame = mavlink::MAV_FRAME_GLOBAL; // relative altitudes would refer to the home that moves
        out.x = degreesE7(home.latitude);
        out.y = degreesE7(home.longitude);
        if (m_kind.isPx4())
            out.parameters[3] = std::nanf(""); // no yaw
        out.parameters[6] = static_cast<float>(homeAltitude());
        return plan(out);
    }

    Plan operator()(const ChangeSpeed &speed) const
    {
        if (!(speed.metresPerSecond > 0))
            return refuse(reasons::kSpeedTooLow);
        const float kind = m_kind.isPlane() ? kAirSpeed : kGroundSpeed;
        return plan(order(mavlink::MAV_CMD_DO_CHANGE_SPEED, kind, static_cast<float>(speed.metresPerSecond), -1));
    }

    Plan operator()(const SetCurrentMissionItem &item) const
    {
        mavlink::MissionSetCurrent message;
        message.target_system = m_addressing.system;
        message.target_component = m_addressing.component;
        message.seq = item.index;
        return CommandPlan{{RepeatedMessage{pack(message, true), true}}, MissionItemIs{item.index}};
    }

    Plan operator()(const StartMission &start) const
    {
        if (m_rules.mission.way == Act::Way::None)
            return refuse(reasons::kNoMission);
        if (m_rules.startsNeedArmed && !m_state.armed) {
            if (!start.prepare)
                return refuse(reasons::kStartNeedsArmed);
            return isIn(m_rules.armsForMissionIn) ? arm(start) : enter(m_rules.armsForMissionIn, start);
        }
        if (m_rules.mission.way == Act::Way::Mode)
            return byMode(m_rules.mission, reasons::kNoMission);
        return plan(order(mavlink::MAV_CMD_MISSION_START));
    }
    Plan operator()(const Reboot &) const { return plan(order(mavlink::MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN, 1)); }

    Plan operator()(const RawCommand &raw) const
    {
        CommandOrder command = order(raw.command);
        std::copy(std::begin(raw.parameters), std::end(raw.parameters), command.parameters);
        CommandPlan out{{command}, {}};
        out.replaces = false; // for example, commands to two servos are independent
        return out;
    }

private:
    static bool isPlace(double latitude, double longitude, double altitude)
    {
        return std::abs(latitude) <= 90 && std::abs(longitude) <= 180 && std::isfinite(altitude);
    }

    /// Metres above mean sea level; NaN if unknown. From both altitudes of the vehicle, since without HOME_POSITION home is
    /// only the place where the vehicle was armed, or first seen armed in flight.
    double homeAltitude() const
    {
        const double own = m_state.position.altitude - m_state.altitudeRelative;
        return std::isnan(own) ? m_state.home.altitude : own;
    }

    /// A COMMAND_INT for a place, whose altitude is above home; nullopt if the vehicle needs another altitude that is not
    /// known. PX4 takes every altitude as one above mean sea level.
    std::optional<CommandOrder> orderAt(std::uint16_t command, double latitude, double longitude, double altitude) const
    {
        CommandOrder out = order(command);
        out.asInt = true;
        out.frame = m_kind.isPx4() ? mavlink::MAV_FRAME_GLOBAL : mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT;
        out.x = degreesE7(latitude);
        out.y = degreesE7(longitude);
        out.parameters[6] = static_cast<float>(m_kind.isPx4() ? altitude + homeAltitude() : altitude);
        return std::isnan(out.parameters[6]) ? std::nullopt : std::optional(out);
    }

    /// Whether the vehicle is in the mode of this autopilot, whatever name the vehicle gives it; true without a name.
    bool isIn(std::string_view mode) const
    {
        const auto number = modeNumber(m_kind, mode);
        return mode.empty() || (number && modeNumber(m_kind, m_state.mode, m_state.ownModes) == number);
    }

    Plan byMode(const Act &act, const Sentence &otherwise) const
    {
        const auto number = act.way == Act::Way::Mode ? modeNumber(m_kind, act.mode) : std::nullopt;
        return number ? setMode(*number) : refuse(otherwise);
    }

    // Steps that prepare a command.
    Plan enter(std::string_view mode, VehicleCommand then) const
    {
        return before(byMode({Act::Way::Mode, mode}, reasons::kModesUnknown), std::move(then));
    }
    Plan arm(VehicleCommand then) const { return before((*this)(Arm{}), std::move(then)); }
    static Plan before(Plan step, VehicleCommand then)
    {
        if (step)
            step->then = std::move(then);
        return step;
    }

    /// MAV_CMD_DO_SET_MODE, or the older SET_MODE message for firmware without it.
    Plan setMode(std::uint32_t number) const
    {
        constexpr std::uint8_t kCustomModeEnabled = mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
        CommandOrder command = order(mavlink::MAV_CMD_DO_SET_MODE, kCustomModeEnabled, static_cast<float>(number));
        if (m_kind.isPx4()) {
            command.parameters[1] = static_cast<float>(number >> 16 & 0xff);
            command.parameters[2] = static_cast<float>(number >> 24);
        }
        return CommandPlan{{command, RepeatedMessage{modeRequest(number), true}},
                           ModeIs{number, modeName(m_kind, kCustomModeEnabled, number, m_state.ownModes)}};
    }

    OutMessage modeRequest(std::uint32_t number) const
    {
        mavlink::SetMode message;
        message.target_system = m_addressing.system;
        message.base_mode = mavlink::MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
        message.custom_mode = number;
        return pack(message, true);
    }

    OutMessage positionTarget(const GoTo &place) const
    {
        mavlink::SetPositionTargetGlobalInt message;
        message.target_system = m_addressing.system;
        message.target_component = m_addressing.component;
        message.coordinate_frame = mavlink::MAV_FRAME_GLOBAL_RELATIVE_ALT_INT;
        message.type_mask = kPositionOnly;
        message.lat_int = degreesE7(place.latitude);
        message.lon_int = degreesE7(place.longitude);
        message.alt = static_cast<float>(place.altitudeRelative);
        return pack(message, true);
    }

    const VehicleState &m_state;
    const Addressing &m_addressing;
    const FlightRules &m_rules;
    VehicleKind m_kind;
};

} // namespace

Result<CommandPlan, Reason> planCommand(const VehicleCommand &command, const VehicleState &state, const Addressing &addressing)
{
    return std::visit(Planner(state, addressing), command);
}

bool armsFirst(const VehicleCommand &command, const VehicleState &state)
{
    const auto *takeOff = std::get_if<TakeOff>(&command);
    const auto *start = std::get_if<StartMission>(&command);
    const bool prepares = (takeOff && takeOff->prepare) || (start && start->prepare);
    return prepares && !state.armed && rulesOf(state).startsNeedArmed && planCommand(command, state, {});
}

} // namespace skyseal::vehicle
