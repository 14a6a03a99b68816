// Detects the loss of a vehicle. Any message of its autopilot proves that it is present, except RADIO_STATUS, which telemetry
// radios insert themselves. HIGH_LATENCY2, by which a vehicle behind a satellite modem sends its whole state seldom, proves it
// until the next ones are overdue.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/autopilot_heartbeat.h"
#include "core/mavlink/message_ids.h"

#include <algorithm>
#include <cstdint>

namespace skyseal::vehicle {

class HeartbeatMonitor
{
public:
    static constexpr Duration kLostAfter = std::chrono::milliseconds(3500);
    /// Before two messages have shown the rate of a high-latency link: PX4 sends one in 67 s (0.015 Hz).
    static constexpr Duration kUnknownRate = std::chrono::seconds(150);

    void handleMessage(TimePoint now, std::uint32_t messageId)
    {
        if (messageId == mavlink::MAVLINK_MSG_ID_RADIO_STATUS)
            return;
        if (mavlink::isHighLatency(messageId))
            handleHighLatency(now);
        m_lastMessage = now;
        if (messageId == mavlink::MAVLINK_MSG_ID_HEARTBEAT)
            m_lastHeartbeat = now;
    }

    /// Of a HEARTBEAT, or a message that stands for it.
    TimePoint lastHeartbeat() const { return std::max(m_lastHeartbeat, m_lastHighLatency); }
    TimePoint lastMessage() const { return m_lastMessage; }
    Duration heartbeatAge(TimePoint now) const { return now - lastHeartbeat(); }
    Duration messageAge(TimePoint now) const { return now - m_lastMessage; }
    /// The silence after which the vehicle is lost.
    Duration lostAfter() const
    {
        if (m_lastHighLatency == TimePoint{})
            return kLostAfter;
        // One message may be lost, and the next one late by half an interval.
        const Duration rare = m_interval == Duration::zero() ? kUnknownRate : m_interval / 2 * 5;
        return std::max(kLostAfter, rare - (m_lastMessage - m_lastHighLatency));
    }
    bool isLost(TimePoint now) const { return messageAge(now) > lostAfter(); }

private:
    void handleHighLatency(TimePoint now)
    {
        if (m_lastHighLatency != TimePoint{}) {
            // A silence is no rate; but where it was one, a few messages show that.
            const Duration interval = now - m_lastHighLatency;
            m_interval = m_interval == Duration::zero() ? std::min(interval, kUnknownRate) : std::min(interval, m_interval * 4);
        }
        m_lastHighLatency = now;
    }

    TimePoint m_lastHeartbeat{};
    TimePoint m_lastMessage{};
    TimePoint m_lastHighLatency{};
    Duration m_interval{}; ///< between the last two of these
};

} // namespace skyseal::vehicle
