// How long a message takes there and back, by TIMESYNC: our time goes out in ts1 and comes back in ts1 of the answer, whose
// tc1 is not zero. Answers the vehicle's own requests as well. https://mavlink.io/en/services/timesync.html
#pragma once

#include "core/base/clock.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/vehicle_config.h"

#include <array>
#include <limits>

namespace skyseal::vehicle {

class TimeSyncClient
{
public:
    static constexpr Duration kInterval = std::chrono::seconds(1);
    static constexpr Duration kSlowInterval = std::chrono::seconds(10); ///< on narrow links
    static constexpr Duration kLongestTrip = std::chrono::seconds(10);  ///< an older answer says nothing

    explicit TimeSyncClient(const Addressing &addressing) : m_addressing(addressing) {}

    void setSlow(bool slow) { m_slow = slow; }
    /// Instead of kInterval, where latency is what is being measured.
    void setInterval(Duration interval) { m_interval = interval; }
    void start(TimePoint now);
    /// `tc1`, `ts1` and the targets of a TIMESYNC of the vehicle.
    void handleTimeSync(TimePoint now, std::int64_t tc1, std::int64_t ts1, std::uint8_t targetSystem,
                        std::uint8_t targetComponent, MessageQueue &outbox);
    void handleDeadline(TimePoint now, MessageQueue &outbox);
    TimePoint nextDeadline() const { return m_next; }

    /// Seconds there and back, smoothed; NaN before the first answer.
    double latency() const { return m_latency; }
    std::uint64_t trips() const { return m_trips; }
    /// Sum over all trips.
    double tripSeconds() const { return m_tripSeconds; }

private:
    Addressing m_addressing;
    bool m_slow = false;
    Duration m_interval = kInterval;
    TimePoint m_next = kNever;
    std::array<std::int64_t, 16> m_sent{}; ///< what answers may refer to; 0 = free
    std::size_t m_slot = 0;
    std::uint64_t m_trips = 0;
    double m_tripSeconds = 0;
    double m_latency = std::numeric_limits<double>::quiet_NaN();
};

} // namespace skyseal::vehicle
