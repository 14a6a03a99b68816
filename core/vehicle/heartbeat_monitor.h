// Detects the loss of a vehicle. Any message of its autopilot proves that it is present, except RADIO_STATUS, which telemetry
// radios insert themselves.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/message_ids.h"

#include <cstdint>

namespace skyseal::vehicle {

class HeartbeatMonitor
{
public:
    static constexpr Duration kLostAfter = std::chrono::milliseconds(3500);

    void handleMessage(TimePoint now, std::uint32_t messageId)
    {
        if (messageId == mavlink::MAVLINK_MSG_ID_RADIO_STATUS)
            return;
        m_lastMessage = now;
        if (messageId == mavlink::MAVLINK_MSG_ID_HEARTBEAT)
            m_lastHeartbeat = now;
    }

    TimePoint lastHeartbeat() const { return m_lastHeartbeat; }
    TimePoint lastMessage() const { return m_lastMessage; }
    Duration heartbeatAge(TimePoint now) const { return now - m_lastHeartbeat; }
    Duration messageAge(TimePoint now) const { return now - m_lastMessage; }
    bool isLost(TimePoint now) const { return messageAge(now) > kLostAfter; }

private:
    TimePoint m_lastHeartbeat{};
    TimePoint m_lastMessage{};
};

} // namespace skyseal::vehicle
