#include "core/mavlink/autopilot_heartbeat.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <array>

namespace skyseal::mavlink {

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
