// Which frames only ask, and so may reach a vehicle from an observer, or late from a pilot: the list of THREATS.md, "What an
// observer may send", read independently of core/engine/common/question_rules.cpp.
#pragma once

#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_scanner.h"
#include "core/mavlink/messages.h"

namespace skyseal::test {

inline bool isHarmlessCommand(std::uint16_t command)
{
    return command == mavlink::MAV_CMD_GET_HOME_POSITION || command == mavlink::MAV_CMD_REQUEST_MESSAGE
        || command == mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION || command == mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES;
}

/// `bytes`: one frame.
inline bool isHarmless(ByteView bytes)
{
    mavlink::FrameScanner scanner(bytes, mavlink::Dialect::builtin());
    const auto item = scanner.next();
    if (!item || !item->frame || item->bytes.size() != bytes.size())
        return false;
    const ByteView payload = item->frame->payload();
    const std::string_view name = item->frame->info().name;
    for (const char *question : {"PARAM_REQUEST_READ", "PARAM_REQUEST_LIST", "PARAM_EXT_REQUEST_READ", "PARAM_EXT_REQUEST_LIST",
                                 "MISSION_REQUEST_LIST", "MISSION_REQUEST", "MISSION_REQUEST_INT"}) {
        if (name == question)
            return true;
    }
    if (name == "TIMESYNC")
        return mavlink::Timesync::decode(payload).tc1 == 0;
    if (name == "MISSION_ACK")
        return mavlink::MissionAck::decode(payload).type == mavlink::MAV_MISSION_ACCEPTED;
    if (name == "COMMAND_LONG")
        return isHarmlessCommand(mavlink::CommandLong::decode(payload).command);
    if (name == "COMMAND_INT")
        return isHarmlessCommand(mavlink::CommandInt::decode(payload).command);
    if (name != "REQUEST_DATA_STREAM")
        return false;
    const auto stream = mavlink::RequestDataStream::decode(payload);
    return stream.start_stop == 1 && stream.req_message_rate >= 1 && stream.req_message_rate <= 10;
}

} // namespace skyseal::test
