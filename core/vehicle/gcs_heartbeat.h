// The station's own heartbeat: its content and its schedule. Vehicles act when it stops, so it is sent only while the
// operator's side answers; the caller decides that.
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/message_queue.h"

#include <optional>

namespace skyseal::vehicle {

/// HEARTBEAT of a ground station (MAV_TYPE_GCS, MAV_AUTOPILOT_INVALID), urgent.
OutMessage gcsHeartbeatMessage();

/// Due once a second, counted from the last one sent, so that a late caller does not send a burst.
class GcsHeartbeat
{
public:
    TimePoint nextDeadline() const { return m_next; }

    /// The message when one is due.
    std::optional<OutMessage> poll(TimePoint now)
    {
        if (now < m_next)
            return std::nullopt;
        m_next = now + std::chrono::seconds(1);
        return gcsHeartbeatMessage();
    }

private:
    TimePoint m_next = TimePoint::min();
};

} // namespace skyseal::vehicle
