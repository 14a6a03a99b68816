#include "core/sim/control_server.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"
#include "core/sim/command_server.h"

namespace skyseal::sim {

using namespace mavlink;

namespace {

// POSITION_TARGET_TYPEMASK: a set bit means "ignore".
constexpr std::uint16_t kIgnorePosition = POSITION_TARGET_TYPEMASK_X_IGNORE | POSITION_TARGET_TYPEMASK_Y_IGNORE
    | POSITION_TARGET_TYPEMASK_Z_IGNORE;
constexpr std::uint16_t kIgnoreVelocity = POSITION_TARGET_TYPEMASK_VX_IGNORE | POSITION_TARGET_TYPEMASK_VY_IGNORE
    | POSITION_TARGET_TYPEMASK_VZ_IGNORE;

bool hasPosition(std::uint16_t mask)
{
    return (mask & kIgnorePosition) == 0;
}
bool hasVelocity(std::uint16_t mask)
{
    return (mask & kIgnoreVelocity) == 0;
}

} // namespace

bool ControlServer::handle(TimePoint now, const Frame &frame)
{
    switch (frame.messageId()) {
    case SetMode::kId: setMode(frame); return true;
    case SetPositionTargetLocalNed::kId: localTarget(frame.payload()); return true;
    case SetPositionTargetGlobalInt::kId: globalTarget(frame.payload()); return true;
    case RcChannelsOverride::kId:
    case ManualControl::kId:
        if (!m_autopilot.parameters().isPilot(frame.systemId()))
            return true; // only one station may hold the sticks
        if (frame.messageId() == ManualControl::kId)
            manualControl(now, frame.payload());
        else
            overrideSticks(now, frame.payload());
        return true;
    default: return false;
    }
}

void ControlServer::report(const Refusal &refusal)
{
    if (refusal)
        m_autopilot.texts().say(Severity::Warning, *refusal);
}

void ControlServer::setMode(const Frame &frame)
{
    const SetMode in = SetMode::decode(frame.payload());
    Refusal refusal;
    CommandAck out;
    // Both acknowledge the message like a command: ArduPilot by the number of the message (GCS_Common.cpp), PX4 by the command
    // that it turns the message into (mavlink_receiver.cpp).
    out.command = m_autopilot.flight().type.isPx4() ? std::uint16_t(MAV_CMD_DO_SET_MODE) : std::uint16_t(SetMode::kId);
    out.target_system = frame.systemId();
    out.target_component = frame.componentId();
    if (!(in.base_mode & MAV_MODE_FLAG_CUSTOM_MODE_ENABLED))
        out.result = MAV_RESULT_DENIED;
    else if (const ModeRow *row = m_autopilot.modes().table().withNumber(in.custom_mode))
        refusal = m_autopilot.requests().enterMode(row->mode);
    else
        refusal = "No such mode " + std::to_string(in.custom_mode);
    if (refusal)
        out.result = m_autopilot.flight().type.isPx4() ? MAV_RESULT_TEMPORARILY_REJECTED : MAV_RESULT_FAILED;
    report(refusal);
    m_outbox.send(out);
}

void ControlServer::face(std::uint16_t mask, double yaw, double offset)
{
    if (!(mask & POSITION_TARGET_TYPEMASK_YAW_IGNORE))
        report(m_autopilot.requests().face(yaw + offset, 0));
}

void ControlServer::localTarget(ByteView payload)
{
    if (!m_autopilot.modes().isGuided())
        return; // streams of targets in another mode are ignored silently
    const auto in = SetPositionTargetLocalNed::decode(payload);
    const Estimate &here = m_autopilot.estimate();
    const bool body = in.coordinate_frame == MAV_FRAME_BODY_NED || in.coordinate_frame == MAV_FRAME_BODY_OFFSET_NED;
    const bool offset = in.coordinate_frame == MAV_FRAME_LOCAL_OFFSET_NED || in.coordinate_frame == MAV_FRAME_BODY_OFFSET_NED;
    if (!body && !offset && in.coordinate_frame != MAV_FRAME_LOCAL_NED)
        return;
    const double yaw = here.attitude.euler().yaw;
    const auto turned = [&](float x, float y, float z) {
        const auto n = static_cast<double>(x), e = static_cast<double>(y), d = static_cast<double>(z);
        return body ? Vector3{n * std::cos(yaw) - e * std::sin(yaw), n * std::sin(yaw) + e * std::cos(yaw), d}
                    : Vector3{n, e, d};
    };
    if (hasPosition(in.type_mask)) {
        const Vector3 place = turned(in.x, in.y, in.z);
        report(m_autopilot.requests().goTo(offset || body ? here.position + place : place));
    } else if (hasVelocity(in.type_mask)) {
        report(m_autopilot.requests().move(turned(in.vx, in.vy, in.vz)));
    }
    face(in.type_mask, static_cast<double>(in.yaw), body ? yaw : 0);
}

void ControlServer::globalTarget(ByteView payload)
{
    if (!m_autopilot.modes().isGuided())
        return;
    const auto in = SetPositionTargetGlobalInt::decode(payload);
    if (hasPosition(in.type_mask)) {
        const auto place = CommandServer::place(m_autopilot, in.coordinate_frame, in.lat_int * 1e-7, in.lon_int * 1e-7,
                                                static_cast<double>(in.alt));
        report(place ? m_autopilot.requests().goTo(*place) : Refusal("Goto: bad place"));
    } else if (hasVelocity(in.type_mask)) {
        report(
            m_autopilot.requests().move({static_cast<double>(in.vx), static_cast<double>(in.vy), static_cast<double>(in.vz)}));
    }
    face(in.type_mask, static_cast<double>(in.yaw), 0);
}

void ControlServer::overrideSticks(TimePoint now, ByteView payload)
{
    const auto in = RcChannelsOverride::decode(payload);
    m_autopilot.flight().pilot.override(
        now, {in.chan1_raw, in.chan2_raw, in.chan3_raw, in.chan4_raw, in.chan5_raw, in.chan6_raw, in.chan7_raw, in.chan8_raw});
}

void ControlServer::manualControl(TimePoint now, ByteView payload)
{
    const auto in = ManualControl::decode(payload);
    const auto axis = [](std::int16_t value) { return std::abs(value) <= 1000 ? value / 1000.0 : 0; }; // beyond: not given
    // Its x is forward-positive; the pitch stick is positive when pulled.
    m_autopilot.flight().pilot.manual(now, {axis(in.y), -axis(in.x), axis(in.r), std::clamp(axis(in.z), 0.0, 1.0)});
}

} // namespace skyseal::sim
