#include "core/vehicle/ping_client.h"

namespace skyseal::vehicle {

bool PingClient::perform(TimePoint now, RequestId id, const Request &request)
{
    if (!std::holds_alternative<Ping>(request))
        return false;
    m_request = id;
    m_attempts = 0;
    transmit(now);
    return true;
}

bool PingClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Ping::kId)
        return false;
    const auto answer = unpack<mavlink::Ping>(frame);
    if (m_deadline != kNever && answer.target_system == addressing().ownSystem && answer.seq == m_sequence) {
        m_deadline = kNever;
        report(PingResult{m_request, addressing().system, true, seconds(now - m_sent)});
    }
    return true;
}

void PingClient::handleDeadline(TimePoint now)
{
    if (now < m_deadline)
        return;
    if (m_attempts < kAttempts)
        return transmit(now);
    m_deadline = kNever;
    report(PingResult{m_request, addressing().system, false, 0, "no answer to " + std::to_string(kAttempts) + " attempts"});
}

void PingClient::transmit(TimePoint now)
{
    mavlink::Ping message;
    message.seq = ++m_sequence;
    message.time_usec = static_cast<std::uint64_t>(now.time_since_epoch().count() / 1000);
    m_context.outbox.push(pack(message, true)); // a request has no target
    ++m_attempts;
    m_sent = now;
    m_deadline = now + kTimeout;
}

} // namespace skyseal::vehicle
