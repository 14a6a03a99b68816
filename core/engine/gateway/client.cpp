#include "core/engine/gateway/client.h"

#include "core/engine/common/question_rules.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/message_ids.h"

namespace skyseal::engine {

namespace {

/// Microseconds between two messages: 10 and 1 a second.
constexpr float kShortestInterval = 100'000, kLongestInterval = 1'000'000;

bool isModestRate(const mavlink::CommandLong &command)
{
    const float interval = command.param2;
    return command.command == mavlink::MAV_CMD_SET_MESSAGE_INTERVAL && (command.param7 == 0)
        && (interval == 0 || (interval >= kShortestInterval && interval <= kLongestInterval));
}

bool mayAsk(const mavlink::Frame &frame)
{
    if (frame.messageId() == mavlink::MAVLINK_MSG_ID_AUTOPILOT_VERSION_REQUEST)
        return true;
    if (frame.messageId() == mavlink::CommandLong::kId && isModestRate(mavlink::CommandLong::decode(frame.payload())))
        return true;
    return isHarmlessQuestion(frame, true);
}

} // namespace

Client::Verdict Client::judge(TimePoint now, const mavlink::ScanItem &item, bool isVehicle)
{
    noteHeard(now);
    const Verdict verdict = judgeUncounted(now, item, isVehicle);
    switch (verdict) {
    case Verdict::Forward: ++m_counters.forwarded; break;
    case Verdict::Ignore: break;
    case Verdict::TooOften: ++m_counters.tooOften; break;
    case Verdict::NotItsSystem: ++m_counters.notItsSystem; break;
    case Verdict::Deny: ++m_counters.denied; break;
    }
    return verdict;
}

Client::Verdict Client::judgeUncounted(TimePoint now, const mavlink::ScanItem &item, bool isVehicle)
{
    if (isVehicle || !m_config.maySpeakAs(mavlink::systemIdOf(item.bytes)))
        return Verdict::NotItsSystem;
    const std::uint32_t messageId = mavlink::messageIdOf(item.bytes);
    if (messageId == mavlink::Heartbeat::kId)
        return m_config.write.any() ? Verdict::Forward : Verdict::Ignore;
    if (m_config.write.mayWrite(messageId))
        return Verdict::Forward;
    if (!item.frame || !mayAsk(*item.frame))
        return Verdict::Deny;
    return m_questions.take(now, messageId) ? Verdict::Forward : Verdict::TooOften;
}

std::optional<Denial> Client::takeDenial(TimePoint now, const mavlink::ScanItem &item)
{
    if (now < m_tellAt)
        return std::nullopt;
    m_tellAt = now + kTellEvery;
    Denial out;
    out.frames = m_counters.denied - std::exchange(m_told, m_counters.denied);
    out.message = item.frame ? std::string(item.frame->info().name) : std::to_string(mavlink::messageIdOf(item.bytes));
    return out;
}

} // namespace skyseal::engine
