#include "core/engine/observer_rules.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/messages.h"

namespace skyseal::engine {

namespace {

/// Messages that are not among the typed ones.
constexpr std::uint32_t kParamExtRequestRead = 320, kParamExtRequestList = 321;

bool isQuestion(std::uint16_t command)
{
    switch (command) {
    case mavlink::MAV_CMD_GET_HOME_POSITION:
    case mavlink::MAV_CMD_GET_MESSAGE_INTERVAL:
    case mavlink::MAV_CMD_REQUEST_MESSAGE:
    case mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION:
    case mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES:
        return true;
    default:
        return false;
    }
}

} // namespace

bool observerMaySend(const mavlink::Frame &frame, bool pilotThere)
{
    switch (frame.messageId()) {
    case mavlink::Ping::kId:
    case mavlink::ParamRequestRead::kId:
    case mavlink::ParamRequestList::kId:
    case kParamExtRequestRead:
    case kParamExtRequestList:
    case mavlink::MissionRequestList::kId:
    case mavlink::MissionRequest::kId:
    case mavlink::MissionRequestInt::kId:
        return true;
    case mavlink::Timesync::kId: // the question alone: PX4 sets its clock's offset by an answer
        return mavlink::Timesync::decode(frame.payload()).tc1 == 0;
    case mavlink::MissionAck::kId: // the end of a download; any other result would cancel one
        return mavlink::MissionAck::decode(frame.payload()).type == mavlink::MAV_MISSION_ACCEPTED;
    case mavlink::RequestDataStream::kId:
        return !pilotThere && mavlink::RequestDataStream::decode(frame.payload()).start_stop == 1;
    case mavlink::CommandLong::kId:
        return isQuestion(mavlink::CommandLong::decode(frame.payload()).command);
    case mavlink::CommandInt::kId:
        return isQuestion(mavlink::CommandInt::decode(frame.payload()).command);
    default:
        return false;
    }
}

} // namespace skyseal::engine
