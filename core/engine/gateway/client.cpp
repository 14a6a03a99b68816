#include "core/engine/gateway/client.h"

#include "core/engine/common/misreading.h"
#include "core/engine/common/question_rules.h"
#include "core/mavlink/frame_header.h"
#include "core/mavlink/messages.h"
#include "core/mavlink/message_ids.h"

namespace skyseal::engine {

namespace {

bool mayAsk(const mavlink::Frame &frame, bool mayStartStreams)
{
    if (!isPlainlySaid(frame))
        return false;
    if (frame.messageId() == mavlink::MAVLINK_MSG_ID_AUTOPILOT_VERSION_REQUEST)
        return true;
    return isHarmlessQuestion(frame, mayStartStreams);
}

} // namespace

Client::Verdict Client::judge(TimePoint now, const mavlink::ScanItem &item, bool isVehicle, bool pilotThere)
{
    noteHeard(now);
    const Verdict verdict = judgeUncounted(now, item, isVehicle, pilotThere);
    switch (verdict) {
    case Verdict::Forward: ++m_counters.forwarded; break;
    case Verdict::Ignore: break;
    case Verdict::TooOften: ++m_counters.tooOften; break;
    case Verdict::NotItsSystem: ++m_counters.notItsSystem; break;
    case Verdict::Deny: ++m_counters.denied; break;
    }
    return verdict;
}

Client::Verdict Client::judgeUncounted(TimePoint now, const mavlink::ScanItem &item, bool isVehicle, bool pilotThere)
{
    if (isVehicle || !m_config.maySpeakAs(mavlink::systemIdOf(item.bytes)))
        return Verdict::NotItsSystem;
    const std::uint32_t messageId = mavlink::messageIdOf(item.bytes);
    if (messageId == mavlink::Heartbeat::kId)
        return m_config.write.any() ? Verdict::Forward : Verdict::Ignore;
    if (m_config.write.mayWrite(item))
        return Verdict::Forward;
    if (!item.frame || !mayAsk(*item.frame, !pilotThere))
        return Verdict::Deny;
    if (mayBeMisread(*item.frame))
        return Verdict::Ignore; // occurs by chance, so it is treated like a loss
    return m_questions.take(now, messageId) ? Verdict::Forward : Verdict::TooOften;
}

std::optional<Denial> Client::takeDenial(TimePoint now, const mavlink::ScanItem &item)
{
    if (now < m_nextNoticeAt)
        return std::nullopt;
    m_nextNoticeAt = now + kNoticeInterval;
    Denial out;
    out.frames = m_counters.denied - std::exchange(m_noticed, m_counters.denied);
    out.message = item.frame ? std::string(item.frame->info().name) : std::to_string(mavlink::messageIdOf(item.bytes));
    return out;
}

} // namespace skyseal::engine
