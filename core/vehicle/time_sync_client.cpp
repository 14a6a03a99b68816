#include "core/vehicle/time_sync_client.h"

#include "core/vehicle/message_io.h"

#include <algorithm>
#include <cmath>

namespace skyseal::vehicle {

namespace {
constexpr double kWeightOfNew = 0.2; // settles within some ten answers, and one late answer does not move it much
}

void TimeSyncClient::start(TimePoint now)
{
    if (m_next == kNever)
        m_next = now;
}

void TimeSyncClient::handleTimeSync(TimePoint now, std::int64_t tc1, std::int64_t ts1, std::uint8_t targetSystem,
                                    std::uint8_t targetComponent, MessageQueue &outbox)
{
    if (!m_addressing.isForUs(targetSystem, targetComponent))
        return;
    if (tc1 == 0) {
        mavlink::Timesync answer;
        answer.tc1 = now.time_since_epoch().count();
        answer.ts1 = ts1;
        answer.target_system = m_addressing.system;
        answer.target_component = m_addressing.component;
        push(outbox, answer, true);
        return;
    }
    // Other stations' answers are broadcast on shared links; only a number that we gave out, once, is ours.
    const auto sent = std::find(m_sent.begin(), m_sent.end(), ts1);
    if (ts1 == 0 || sent == m_sent.end())
        return;
    *sent = 0;
    const Duration trip = now.time_since_epoch() - Duration(ts1);
    if (trip < Duration::zero() || trip > kLongestTrip)
        return;
    const double measured = seconds(trip);
    ++m_trips;
    m_tripSeconds += measured;
    m_latency = std::isnan(m_latency) ? measured : m_latency + kWeightOfNew * (measured - m_latency);
}

void TimeSyncClient::handleDeadline(TimePoint now, MessageQueue &outbox)
{
    if (now < m_next)
        return;
    m_next = now + (m_slow ? kSlowInterval : m_interval);
    mavlink::Timesync request;
    request.tc1 = 0;
    request.ts1 = std::max<std::int64_t>(now.time_since_epoch().count(), 1);
    request.target_system = m_addressing.system;
    request.target_component = m_addressing.component;
    m_sent[m_slot] = request.ts1;
    m_slot = (m_slot + 1) % m_sent.size();
    push(outbox, request, true);
}

} // namespace skyseal::vehicle
