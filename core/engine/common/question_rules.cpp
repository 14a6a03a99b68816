#include "core/engine/common/question_rules.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/message_ids.h"
#include "core/mavlink/messages.h"

#include <bit>
#include <cmath>
#include <type_traits>

namespace skyseal::engine {

namespace {

/// Rates of the streams that may be started; the defaults of stations are within this range.
constexpr std::uint16_t kLeastRate = 1, kGreatestRate = 10; // Hz

bool isWholeUpTo(float value, float most)
{
    return value >= 0 && value <= most && std::trunc(value) == value;
}

/// Zero, or the NaN that libraries write; any other value would be usable space for an attacker.
bool isUnused(float value)
{
    return value == 0 || std::bit_cast<std::uint32_t>(value) == 0x7fc00000;
}

bool isMessageId(float value)
{
    return isWholeUpTo(value, 0xffffff);
}

/// Returns true for the intervals in microseconds of 1, 2, … 10 Hz, exact or as whole numbers, both of which stations write.
/// The many intervals between them would be usable space for an attacker.
bool isIntervalOfAPermittedRate(float interval)
{
    for (int rate = kLeastRate; rate <= kGreatestRate; ++rate) {
        const double exact = 1e6 / rate;
        for (const double written : {exact, std::trunc(exact), std::round(exact)}) {
            if (interval == static_cast<float>(written))
                return true;
        }
    }
    return false;
}

/// A question has a message id, an index and the address of the answer, a request for a rate has a message id, an interval and
/// that address; other parameters would be usable space for an attacker.
template<typename Command> bool asks(const Command &said, bool mayStartStreams)
{
    bool rest = isUnused(said.param3) && isUnused(said.param4);
    if constexpr (std::is_same_v<Command, mavlink::CommandLong>)
        rest = rest && isUnused(said.param5) && isUnused(said.param6) && (isWholeUpTo(said.param7, 2) || isUnused(said.param7));
    else
        rest = rest && said.x == 0 && said.y == 0 && (isWholeUpTo(said.z, 2) || isUnused(said.z));
    if (said.command == mavlink::MAV_CMD_SET_MESSAGE_INTERVAL)
        return rest && mayStartStreams && isMessageId(said.param1) && isIntervalOfAPermittedRate(said.param2);
    return rest && isQuestion(said.command) && (isMessageId(said.param1) || isUnused(said.param1))
        && (isWholeUpTo(said.param2, 255) || isUnused(said.param2));
}

bool startsStream(const mavlink::RequestDataStream &request)
{
    return request.start_stop == 1 && request.req_message_rate >= kLeastRate && request.req_message_rate <= kGreatestRate;
}

} // namespace

bool isListRequest(std::uint32_t messageId)
{
    return messageId == mavlink::ParamRequestList::kId || messageId == mavlink::MAVLINK_MSG_ID_PARAM_EXT_REQUEST_LIST;
}

bool isQuestion(std::uint16_t command)
{
    switch (command) {
    case mavlink::MAV_CMD_GET_HOME_POSITION:
    case mavlink::MAV_CMD_REQUEST_MESSAGE:
    case mavlink::MAV_CMD_REQUEST_PROTOCOL_VERSION:
    case mavlink::MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: return true;
    default: return false;
    }
}

bool isHarmlessQuestion(const mavlink::Frame &frame, bool mayStartStreams)
{
    switch (frame.messageId()) {
    case mavlink::ParamRequestRead::kId:
    case mavlink::ParamRequestList::kId:
    case mavlink::MAVLINK_MSG_ID_PARAM_EXT_REQUEST_READ:
    case mavlink::MAVLINK_MSG_ID_PARAM_EXT_REQUEST_LIST:
    case mavlink::MissionRequestList::kId:
    case mavlink::MissionRequest::kId:
    case mavlink::MissionRequestInt::kId: return true;
    case mavlink::Timesync::kId: // only the request: PX4 sets its clock offset by an answer
        return mavlink::Timesync::decode(frame.payload()).tc1 == 0;
    case mavlink::MissionAck::kId: // ends a download; any other result would cancel one
        return mavlink::MissionAck::decode(frame.payload()).type == mavlink::MAV_MISSION_ACCEPTED;
    case mavlink::RequestDataStream::kId:
        return mayStartStreams && startsStream(mavlink::RequestDataStream::decode(frame.payload()));
    case mavlink::CommandLong::kId: return asks(mavlink::CommandLong::decode(frame.payload()), mayStartStreams);
    case mavlink::CommandInt::kId: return asks(mavlink::CommandInt::decode(frame.payload()), mayStartStreams);
    default: return false;
    }
}

} // namespace skyseal::engine
