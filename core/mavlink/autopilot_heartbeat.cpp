#include "core/mavlink/autopilot_heartbeat.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <array>

namespace skyseal::mavlink {

namespace {

Heartbeat heartbeatFrom(const HighLatency2 &m, const Heartbeat &before)
{
    Heartbeat out = before;
    out.type = m.type;
    out.autopilot = m.autopilot;
    out.custom_mode = m.autopilot == MAV_AUTOPILOT_PX4 ? std::uint32_t(m.custom_mode) << 16
                                                       : m.custom_mode; // main and sub mode of PX4
    bool armed = (before.base_mode & MAV_MODE_FLAG_SAFETY_ARMED) != 0 || m.throttle > 0;
    if (m.autopilot == MAV_AUTOPILOT_ARDUPILOTMEGA) // GCS_MAVLINK::send_high_latency2() puts its base mode there
        armed = (m.custom0 & MAV_MODE_FLAG_SAFETY_ARMED) != 0;
    out.base_mode = MAV_MODE_FLAG_CUSTOM_MODE_ENABLED;
    if (armed)
        out.base_mode |= MAV_MODE_FLAG_SAFETY_ARMED;
    return out;
}

Heartbeat heartbeatFrom(const HighLatency &m, const Heartbeat &before)
{
    Heartbeat out = before;
    out.custom_mode = m.custom_mode;
    out.base_mode = m.base_mode;
    return out;
}

} // namespace

bool isHighLatency(std::uint32_t messageId)
{
    return messageId == HighLatency2::kId || messageId == HighLatency::kId;
}

std::optional<Heartbeat> heartbeatOf(const Frame &frame, const Heartbeat &before)
{
    switch (frame.messageId()) {
    case Heartbeat::kId: return Heartbeat::decode(frame.payload());
    case HighLatency2::kId: return heartbeatFrom(HighLatency2::decode(frame.payload()), before);
    case HighLatency::kId: return heartbeatFrom(HighLatency::decode(frame.payload()), before);
    default: return std::nullopt;
    }
}

AutopilotClaim autopilotClaim(std::uint8_t componentId, const Heartbeat &heartbeat)
{
    if (heartbeat.autopilot == MAV_AUTOPILOT_INVALID) // the component declares that it is no autopilot
        return AutopilotClaim::None;
    constexpr std::array<std::uint8_t, 19> kNoVehicles{MAV_TYPE_GCS,         MAV_TYPE_ONBOARD_CONTROLLER,
                                                       MAV_TYPE_GIMBAL,      MAV_TYPE_ADSB,
                                                       MAV_TYPE_CAMERA,      MAV_TYPE_CHARGING_STATION,
                                                       MAV_TYPE_FLARM,       MAV_TYPE_SERVO,
                                                       MAV_TYPE_ODID,        MAV_TYPE_BATTERY,
                                                       MAV_TYPE_PARACHUTE,   MAV_TYPE_LOG,
                                                       MAV_TYPE_OSD,         MAV_TYPE_IMU,
                                                       MAV_TYPE_GPS,         MAV_TYPE_WINCH,
                                                       MAV_TYPE_ILLUMINATOR, MAV_TYPE_GRIPPER,
                                                       MAV_TYPE_RADIO};
    if (std::find(kNoVehicles.begin(), kNoVehicles.end(), heartbeat.type) != kNoVehicles.end())
        return AutopilotClaim::None;
    if (componentId == MAV_COMP_ID_AUTOPILOT1)
        return AutopilotClaim::Component;
    if (heartbeat.autopilot != MAV_AUTOPILOT_GENERIC)
        return AutopilotClaim::Named;
    // A companion's library that fills the message with zeros names neither a vehicle nor an autopilot.
    return heartbeat.type == MAV_TYPE_GENERIC ? AutopilotClaim::None : AutopilotClaim::Generic;
}

} // namespace skyseal::mavlink
