// Values of parameter 2 of MAV_CMD_COMPONENT_ARM_DISARM that override the checks of the autopilot. They are in no enum of
// the dialects.
#pragma once

namespace skyseal::mavlink {

/// Arms or disarms by force: the description of the command in common.xml.
inline constexpr float kForceArmDisarm = 21196;
/// ArduPilot's own value, which only arms (AP_Arming: magic_force_arm_value).
inline constexpr float kForceArmArduPilot = 2989;

} // namespace skyseal::mavlink
