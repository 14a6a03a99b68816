#include "core/vehicle/time_sync_client.h"

#include <algorithm>
#include <cmath>

namespace skyseal::vehicle {

namespace {
constexpr double kWeightOfNew = 0.2; // settles within about ten answers; a single late answer has little effect
}

void TimeSyncClient::handleHeartbeat(TimePoint now)
{
    if (m_next == kNever)
        m_next = now;
}

bool TimeSyncClient::handleFrame(TimePoint now, const mavlink::Frame &frame)
{
    if (frame.messageId() != mavlink::Timesync::kId)
        return false;
    const auto m = unpack<mavlink::Timesync>(frame);
    if (!addressing().isForUs(m.target_system, m.target_component))
        return true;
    if (m.tc1 == 0) {
        mavlink::Timesync answer;
        answer.tc1 = now.time_since_epoch().count();
        answer.ts1 = m.ts1;
        send(answer);
    } else {
        takeAnswer(now, m.ts1);
    }
    return true;
}

void TimeSyncClient::takeAnswer(TimePoint now, std::int64_t sentTime)
{
    // Answers to other stations are broadcast on shared links; only an outstanding ts1 of this station counts, once.
    const auto sent = std::find(m_sent.begin(), m_sent.end(), sentTime);
    if (sentTime == 0 || sent == m_sent.end())
        return;
    *sent = 0;
    const Duration trip = now.time_since_epoch() - Duration(sentTime);
    if (trip < Duration::zero() || trip > kLongestTrip)
        return;
    const double measured = seconds(trip);
    VehicleState &s = state();
    ++s.trips;
    s.tripSeconds += measured;
    s.latency = std::isnan(s.latency) ? measured : s.latency + kWeightOfNew * (measured - s.latency);
}

void TimeSyncClient::handleDeadline(TimePoint now)
{
    if (now < nextDeadline())
        return;
    m_next = now + (m_slow ? kSlowInterval : m_interval);
    mavlink::Timesync request;
    request.ts1 = std::max<std::int64_t>(now.time_since_epoch().count(), 1);
    m_sent[m_slot] = request.ts1;
    m_slot = (m_slot + 1) % m_sent.size();
    send(request);
}

} // namespace skyseal::vehicle
