// Messages that clients receive even if a newer message of the same kind overtook them: answers, each of which names its
// request (a parameter, an item, a command, an offset), and events. Their order does not matter, and without them the client
// repeats its request or never learns of the event. Telemetry is not among them, since old values would replace newer ones.
#pragma once

#include "core/mavlink/message_ids.h"

#include <cstdint>

namespace skyseal::engine {

constexpr bool isLateAnswer(std::uint32_t messageId)
{
    switch (messageId) {
    case mavlink::MAVLINK_MSG_ID_PARAM_VALUE:
    case mavlink::MAVLINK_MSG_ID_PARAM_ERROR:
    case mavlink::MAVLINK_MSG_ID_MISSION_REQUEST:
    case mavlink::MAVLINK_MSG_ID_MISSION_REQUEST_INT:
    case mavlink::MAVLINK_MSG_ID_MISSION_COUNT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM_INT:
    case mavlink::MAVLINK_MSG_ID_MISSION_ACK:
    case mavlink::MAVLINK_MSG_ID_COMMAND_ACK:
    case mavlink::MAVLINK_MSG_ID_FILE_TRANSFER_PROTOCOL:
    case mavlink::MAVLINK_MSG_ID_LOG_ENTRY:
    case mavlink::MAVLINK_MSG_ID_LOG_DATA:
    case mavlink::MAVLINK_MSG_ID_AUTOPILOT_VERSION:
    case mavlink::MAVLINK_MSG_ID_PROTOCOL_VERSION:
    case mavlink::MAVLINK_MSG_ID_MESSAGE_INTERVAL:
    case mavlink::MAVLINK_MSG_ID_AVAILABLE_MODES:
    case mavlink::MAVLINK_MSG_ID_COMPONENT_INFORMATION_BASIC:
    case mavlink::MAVLINK_MSG_ID_COMPONENT_METADATA:
    case mavlink::MAVLINK_MSG_ID_PARAM_EXT_VALUE:
    case mavlink::MAVLINK_MSG_ID_PARAM_EXT_ACK:
    case mavlink::MAVLINK_MSG_ID_FENCE_POINT:
    case mavlink::MAVLINK_MSG_ID_RALLY_POINT:
    case mavlink::MAVLINK_MSG_ID_REMOTE_LOG_DATA_BLOCK:
    case mavlink::MAVLINK_MSG_ID_LOGGING_DATA:
    case mavlink::MAVLINK_MSG_ID_LOGGING_DATA_ACKED:
    case mavlink::MAVLINK_MSG_ID_DEVICE_OP_READ_REPLY:
    case mavlink::MAVLINK_MSG_ID_DEVICE_OP_WRITE_REPLY:
    case mavlink::MAVLINK_MSG_ID_SERIAL_CONTROL:
    case mavlink::MAVLINK_MSG_ID_PING:
    case mavlink::MAVLINK_MSG_ID_TIMESYNC:
    case mavlink::MAVLINK_MSG_ID_EVENT:
    case mavlink::MAVLINK_MSG_ID_RESPONSE_EVENT_ERROR:
    case mavlink::MAVLINK_MSG_ID_MISSION_ITEM_REACHED:
    case mavlink::MAVLINK_MSG_ID_MAG_CAL_REPORT:
    case mavlink::MAVLINK_MSG_ID_CAMERA_FEEDBACK:
    case mavlink::MAVLINK_MSG_ID_CAMERA_IMAGE_CAPTURED:
    case mavlink::MAVLINK_MSG_ID_STATUSTEXT: return true;
    default: return false;
    }
}

} // namespace skyseal::engine
