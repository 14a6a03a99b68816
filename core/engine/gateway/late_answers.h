// Messages of conversations, which clients receive although a newer one of their kind overtook them: each names what it answers
// (a parameter, an item, a command, an offset), so that its place does not matter, and without it the client asks again.
// Telemetry is not among them, since it would set a display back.
#pragma once

#include "core/mavlink/message_ids.h"

#include <cstdint>

namespace skyseal::engine {

constexpr bool isLateAnswer(std::uint32_t messageId)
{
    switch (messageId) {
    case mavlink::MAVLINK_MSG_ID_PARAM_VALUE:
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
    case mavlink::MAVLINK_MSG_ID_STATUSTEXT: return true;
    default: return false;
    }
}

} // namespace skyseal::engine
