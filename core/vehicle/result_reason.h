// The result codes of MAVLink as reasons.
#pragma once

#include "core/base/reason.h"
#include "core/mavlink/ftp_message.h"

#include <cstdint>

namespace skyseal::vehicle {

/// MAV_RESULT: "denied", "not supported", …
Reason commandResultReason(std::uint8_t result);
/// MAV_MISSION_RESULT: "no space left on the vehicle", …
Reason missionResultReason(std::uint8_t result);
/// MAV_PARAM_ERROR: "the parameter is read-only", …
Reason parameterErrorReason(std::uint8_t error);
/// A refusal of MAVLink FTP: "no such file or folder", …; of MAV_FTP_ERR_FAILERRNO with the number that the vehicle sends.
Reason ftpErrorReason(const mavlink::FtpMessage &refusal);

} // namespace skyseal::vehicle
