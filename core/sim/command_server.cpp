#include "core/sim/command_server.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/force_arm.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/px4_mode.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

/// A float of the wire as an index: out of range or not-a-number gives 2^32-1, which names nothing.
std::uint32_t index(float value)
{
    return value >= 0 && value < 1e7f ? static_cast<std::uint32_t>(value) : 0xffffffffu;
}

} // namespace

void CommandServer::handle(TimePoint now, const FrameSender &peer, const Command &command)
{
    CommandAck out;
    out.command = command.id;
    out.result = execute(now, command);
    out.target_system = peer.system;
    out.target_component = peer.component;
    m_outbox.send(out);
}

std::uint8_t CommandServer::execute(TimePoint now, const Command &command)
{
    switch (command.id) {
    case MAV_CMD_COMPONENT_ARM_DISARM: return arm(command);
    case MAV_CMD_DO_SET_MODE: return setMode(command);
    case MAV_CMD_REQUEST_MESSAGE: return requestMessage(index(command.parameters[0]));
    case MAV_CMD_SET_MESSAGE_INTERVAL: return setInterval(now, command);
    case MAV_CMD_GET_MESSAGE_INTERVAL: return getInterval(index(command.parameters[0]));
    case MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES:
        return command.parameters[0] == 1 ? requestMessage(AutopilotVersion::kId) : std::uint8_t(MAV_RESULT_DENIED);
    case MAV_CMD_GET_HOME_POSITION: return requestMessage(HomePosition::kId);
    case MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN: return reboot(command);
    case MAV_CMD_DO_SET_HOME: return setHome(command);
    case MAV_CMD_DO_SET_MISSION_CURRENT: return setCurrent(command);
    case MAV_CMD_DO_FENCE_ENABLE: return enableFence(index(command.parameters[0]));
    case MAV_CMD_MISSION_START: return answer(m_autopilot.requests().startMission());
    case MAV_CMD_RUN_PREARM_CHECKS:
        if (const auto reason = m_autopilot.arming().preArm())
            m_autopilot.texts().say(Severity::Critical, "PreArm: " + *reason);
        return MAV_RESULT_ACCEPTED;
    default: return fly(command);
    }
}

std::uint8_t CommandServer::fly(const Command &command)
{
    switch (command.id) {
    case MAV_CMD_NAV_TAKEOFF: return takeOff(command);
    case MAV_CMD_NAV_LAND: return enter(FlightMode::Land);
    case MAV_CMD_NAV_RETURN_TO_LAUNCH: return enter(FlightMode::Rtl);
    case MAV_CMD_NAV_LOITER_UNLIM: return enter(m_autopilot.flight().type.isPx4() ? FlightMode::Guided : FlightMode::Loiter);
    case MAV_CMD_DO_REPOSITION: return reposition(command);
    case MAV_CMD_CONDITION_YAW: return yaw(command);
    case MAV_CMD_DO_SET_ROI:
    case MAV_CMD_DO_SET_ROI_LOCATION: return pointAt(command);
    case MAV_CMD_DO_SET_ROI_NONE: return pointAt({command.id, MAV_FRAME_GLOBAL, {}, 0, 0, 0});
    case MAV_CMD_DO_CHANGE_SPEED: return changeSpeed(command);
    default: return MAV_RESULT_UNSUPPORTED;
    }
}

std::uint8_t CommandServer::answer(const Refusal &refusal)
{
    if (!refusal)
        return MAV_RESULT_ACCEPTED;
    const bool arming = refusal->starts_with("PreArm") || refusal->starts_with("Arm");
    m_autopilot.texts().say(arming ? Severity::Critical : Severity::Warning, *refusal);
    // PX4 says that the time is wrong, not that it failed (Commander.cpp).
    return m_autopilot.flight().type.isPx4() ? MAV_RESULT_TEMPORARILY_REJECTED : MAV_RESULT_FAILED;
}

std::uint8_t CommandServer::takeOff(const Command &command)
{
    const VehicleType &type = m_autopilot.flight().type;
    if (type.isRover())
        return MAV_RESULT_UNSUPPORTED;
    auto height = static_cast<double>(command.z);
    if (type.isPx4()) { // above mean sea level, or not-a-number for the usual height
        const FlightContext &flight = m_autopilot.flight();
        const double ground = flight.world.origin().altitude - flight.home.orOrigin().z;
        height = std::isnan(height) ? flight.settings.takeOffHeight : height - ground;
    }
    return answer(m_autopilot.requests().takeOff(height));
}

std::uint8_t CommandServer::enter(FlightMode mode)
{
    return m_autopilot.modes().table().find(mode) ? answer(m_autopilot.requests().enterMode(mode))
                                                  : std::uint8_t(MAV_RESULT_UNSUPPORTED);
}

std::uint8_t CommandServer::arm(const Command &command)
{
    const bool force = command.parameters[1] == kForceArmDisarm;
    if (command.parameters[0] == 1)
        return answer(m_autopilot.arming().arm(force || command.parameters[1] == kForceArmArduPilot));
    if (command.parameters[0] == 0)
        return answer(m_autopilot.arming().disarm(force));
    return MAV_RESULT_UNSUPPORTED;
}

std::uint8_t CommandServer::setMode(const Command &command)
{
    if (!(index(command.parameters[0]) & MAV_MODE_FLAG_CUSTOM_MODE_ENABLED) || index(command.parameters[0]) > 255)
        return MAV_RESULT_DENIED; // both firmwares have custom modes only
    const bool px4 = m_autopilot.flight().type.isPx4();
    const std::uint32_t number = px4 ? px4Mode(index(command.parameters[1]) & 0xff, index(command.parameters[2]) & 0xff)
                                     : index(command.parameters[1]);
    const ModeRow *row = m_autopilot.modes().table().withNumber(number);
    if (!row)
        return answer("No such mode " + std::to_string(number));
    return answer(m_autopilot.requests().enterMode(row->mode));
}

std::optional<Vector3> CommandServer::place(const Autopilot &autopilot, std::uint8_t frame, double latitude, double longitude,
                                            double altitude)
{
    Vector3 out = autopilot.estimate().position;
    if (latitude != 0 || longitude != 0) {
        if (!(std::abs(latitude) <= 90) || !(std::abs(longitude) <= 180))
            return std::nullopt;
        out = autopilot.flight().world.toLocal({latitude, longitude, 0});
    }
    if (!std::isfinite(altitude) || std::abs(altitude) > 10000)
        return std::nullopt;
    switch (frame) {
    case MAV_FRAME_GLOBAL:
    case MAV_FRAME_GLOBAL_INT: out.z = autopilot.flight().world.origin().altitude - altitude; return out;
    case MAV_FRAME_GLOBAL_RELATIVE_ALT:
    case MAV_FRAME_GLOBAL_RELATIVE_ALT_INT: // flat ground: terrain is where home is
    case MAV_FRAME_GLOBAL_TERRAIN_ALT:
    case MAV_FRAME_GLOBAL_TERRAIN_ALT_INT: out.z = autopilot.flight().situation().home.z - altitude; return out;
    default: return std::nullopt;
    }
}

std::optional<Vector3> CommandServer::repositionTarget(const Command &command) const
{
    const auto altitude = static_cast<double>(command.z);
    if (!m_autopilot.flight().type.isPx4())
        return place(m_autopilot, command.frame, command.x, command.y, altitude);
    // PX4 takes every altitude as one above mean sea level, and keeps its target without a place (navigator_main.cpp).
    const bool keepsPlace = std::isnan(command.x) && std::isnan(command.y);
    auto target = place(m_autopilot, MAV_FRAME_GLOBAL, keepsPlace ? 0 : command.x, keepsPlace ? 0 : command.y, altitude);
    const auto present = m_autopilot.modes().place(m_autopilot.flight().situation());
    if (target && present && keepsPlace) {
        target->x = present->x;
        target->y = present->y;
    }
    return target;
}

std::uint8_t CommandServer::reposition(const Command &command)
{
    const auto target = repositionTarget(command);
    if (!target)
        return MAV_RESULT_DENIED;
    if (!m_autopilot.modes().isGuided()) {
        if (!(index(command.parameters[1]) & MAV_DO_REPOSITION_FLAGS_CHANGE_MODE))
            return MAV_RESULT_DENIED;
        if (const auto refusal = m_autopilot.requests().enterMode(FlightMode::Guided))
            return answer(refusal);
    }
    if (const auto refusal = m_autopilot.requests().goTo(*target))
        return answer(refusal);
    if (command.parameters[0] > 0)
        return answer(
            m_autopilot.requests().changeSpeed(FlightRequests::SpeedKind::Ground, static_cast<double>(command.parameters[0])));
    return MAV_RESULT_ACCEPTED;
}

std::uint8_t CommandServer::yaw(const Command &command)
{
    const auto &[angle, rate, direction, relative] = command.parameters;
    const double turn = radians(static_cast<double>(angle));
    const double from = m_autopilot.estimate().attitude.euler().yaw;
    const double heading = relative == 1 ? from + (direction < 0 ? -turn : turn) : turn;
    return answer(m_autopilot.requests().face(heading, radians(static_cast<double>(rate))));
}

/// There is no camera that could pan: a copter of ArduPilot turns its nose, PX4 accepts and turns nothing, and ArduPilot's
/// other vehicles refuse (GCS_Common.cpp, without a mount).
std::uint8_t CommandServer::pointAt(const Command &command)
{
    const VehicleType &type = m_autopilot.flight().type;
    if (type.isPx4())
        return MAV_RESULT_ACCEPTED;
    if (!type.hovers())
        return MAV_RESULT_UNSUPPORTED;
    if (command.x == 0 && command.y == 0 && command.z == 0) {
        m_autopilot.requests().pointAt(std::nullopt);
        return MAV_RESULT_ACCEPTED;
    }
    const auto target = place(m_autopilot, command.frame, command.x, command.y, static_cast<double>(command.z));
    if (!target)
        return MAV_RESULT_DENIED;
    m_autopilot.requests().pointAt(*target);
    return MAV_RESULT_ACCEPTED;
}

std::uint8_t CommandServer::changeSpeed(const Command &command)
{
    using Kind = FlightRequests::SpeedKind;
    const std::uint32_t kind = index(command.parameters[0]);
    if (kind > SPEED_TYPE_DESCENT_SPEED)
        return MAV_RESULT_DENIED;
    return answer(m_autopilot.requests().changeSpeed(kind == SPEED_TYPE_CLIMB_SPEED         ? Kind::Climb
                                                         : kind == SPEED_TYPE_DESCENT_SPEED ? Kind::Descent
                                                                                            : Kind::Ground,
                                                     static_cast<double>(command.parameters[1])));
}

std::uint8_t CommandServer::setHome(const Command &command)
{
    std::optional<Vector3> home = m_autopilot.estimate().position;
    if (command.parameters[0] != 1)
        home = place(m_autopilot, command.frame, command.x, command.y, static_cast<double>(command.z));
    if (!home || !m_autopilot.requests().setHome(*home))
        return MAV_RESULT_FAILED;
    m_telemetry.send(HomePosition::kId);
    return MAV_RESULT_ACCEPTED;
}

std::uint8_t CommandServer::setCurrent(const Command &command)
{
    const std::uint32_t sequence = index(command.parameters[0]);
    if (sequence > 0xffff || !m_autopilot.modes().mission().setCurrent(static_cast<std::uint16_t>(sequence)))
        return MAV_RESULT_FAILED;
    return MAV_RESULT_ACCEPTED;
}

std::uint8_t CommandServer::enableFence(std::uint32_t what)
{
    Fence &fence = m_autopilot.flight().fence;
    switch (what) {
    case 0: fence.enable(false); return MAV_RESULT_ACCEPTED;
    case 1:
        if (!fence.present())
            return MAV_RESULT_FAILED;
        fence.enable(true);
        return MAV_RESULT_ACCEPTED;
    case 2: fence.disableFloor(); return MAV_RESULT_ACCEPTED;
    default: return MAV_RESULT_FAILED;
    }
}

std::uint8_t CommandServer::requestMessage(std::uint32_t message)
{
    return m_telemetry.send(message) ? MAV_RESULT_ACCEPTED : MAV_RESULT_FAILED;
}

std::uint8_t CommandServer::setInterval(TimePoint now, const Command &command)
{
    const float micros = command.parameters[1];
    if (!std::isfinite(micros) || micros > 3.6e9f) // no slower than once an hour
        return MAV_RESULT_DENIED;
    const auto interval = micros < 0 ? Duration(-1)
                                     : std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::micro>(micros));
    return m_streams.setInterval(now, index(command.parameters[0]), interval) ? MAV_RESULT_ACCEPTED : MAV_RESULT_FAILED;
}

std::uint8_t CommandServer::getInterval(std::uint32_t message)
{
    MessageInterval out;
    out.message_id = static_cast<std::uint16_t>(message);
    if (const auto interval = m_streams.interval(message); interval && message <= 0xffff)
        out.interval_us = *interval == Duration::zero() ? -1
                                                        : static_cast<std::int32_t>(*interval / std::chrono::microseconds(1));
    m_outbox.send(out); // 0: not available
    return MAV_RESULT_ACCEPTED;
}

std::uint8_t CommandServer::reboot(const Command &command)
{
    if (command.parameters[0] != 1 && command.parameters[0] != 3)
        return MAV_RESULT_UNSUPPORTED;
    if (m_autopilot.armed())
        return MAV_RESULT_FAILED;
    m_reboot = true;
    return MAV_RESULT_ACCEPTED;
}

} // namespace skyseal::sim
