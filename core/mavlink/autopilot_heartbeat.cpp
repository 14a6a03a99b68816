#include "core/mavlink/autopilot_heartbeat.h"

#include "core/mavlink/enums.h"

#include <algorithm>
#include <array>

namespace skyseal::mavlink {

bool isAutopilot(const Heartbeat &heartbeat)
{
    if (heartbeat.autopilot == MAV_AUTOPILOT_INVALID) // the component declares that it is no autopilot
        return false;
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
    return std::find(kNoVehicles.begin(), kNoVehicles.end(), heartbeat.type) == kNoVehicles.end();
}

} // namespace skyseal::mavlink
