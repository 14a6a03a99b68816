// How long a vehicle has been silent. Any message of its autopilot proves that it is there, except RADIO_STATUS, which
// radios put in by themselves. Nothing is erased when it is lost.
#pragma once

#include "core/base/clock.h"

#include <cstdint>

namespace skyseal::vehicle {

class HeartbeatMonitor
{
public:
    static constexpr Duration kLostAfter = std::chrono::milliseconds(3500);
    static constexpr std::uint32_t kHeartbeat = 0;
    static constexpr std::uint32_t kRadioStatus = 109;

    void handleMessage(TimePoint now, std::uint32_t messageId)
    {
        if (messageId == kRadioStatus)
            return;
        m_lastMessage = now;
        if (messageId == kHeartbeat)
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
