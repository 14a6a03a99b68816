#include "core/engine/common/urgency.h"

#include "core/mavlink/enums.h"
#include "core/mavlink/frame.h"
#include "core/mavlink/messages.h"

#include <algorithm>

namespace skyseal::engine {

namespace {

using namespace mavlink;

constexpr std::uint32_t kUrgent[] = {SetMode::kId,
                                     CommandInt::kId,
                                     CommandLong::kId,
                                     CommandAck::kId,
                                     CommandCancel::kId,
                                     ManualControl::kId,
                                     RcChannelsOverride::kId,
                                     SetAttitudeTarget::kId,
                                     SetPositionTargetLocalNed::kId,
                                     SetPositionTargetGlobalInt::kId,
                                     MissionRequestPartialList::kId,
                                     MissionWritePartialList::kId,
                                     MissionItem::kId,
                                     MissionRequest::kId,
                                     MissionSetCurrent::kId,
                                     MissionRequestList::kId,
                                     MissionCount::kId,
                                     MissionClearAll::kId,
                                     MissionAck::kId,
                                     MissionRequestInt::kId,
                                     MissionItemInt::kId};

} // namespace

bool isUrgent(ByteView frame)
{
    const bool second = frame.size() > 10 && frame[0] == kMagic2;
    if (!second && frame.size() < 7)
        return false;
    const std::uint32_t id = second ? frame[7] | frame[8] << 8 | static_cast<std::uint32_t>(frame[9]) << 16
                                    : std::uint32_t(frame[5]);
    const ByteView payload = frame.subspan(second ? 10 : 6);
    constexpr std::size_t kType = 4; // of a HEARTBEAT's payload
    if (id == Heartbeat::kId)
        return payload.size() > kType && payload[kType] == MAV_TYPE_GCS;
    return std::find(std::begin(kUrgent), std::end(kUrgent), id) != std::end(kUrgent);
}

} // namespace skyseal::engine
