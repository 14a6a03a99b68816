// Measures the round-trip time with TIMESYNC: the request carries the station's time in ts1, and the answer returns it there
// with a tc1 other than zero. Also answers the vehicle's own requests. https://mavlink.io/en/services/timesync.html
#pragma once

#include "core/vehicle/micro_protocol.h"

#include <array>

namespace skyseal::vehicle {

class TimeSyncClient : public MicroProtocol
{
public:
    static constexpr Duration kInterval = std::chrono::seconds(1);
    static constexpr Duration kSlowInterval = std::chrono::seconds(10); ///< on narrow links
    static constexpr Duration kLongestTrip = std::chrono::seconds(10);  ///< later answers are ignored

    using MicroProtocol::MicroProtocol;

    void setSlow(bool slow) { m_slow = slow; }
    /// Replaces kInterval, for measurements of latency.
    void setInterval(Duration interval) { m_interval = interval; }

    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return mayAsk() ? m_next : kNever; }

private:
    void takeAnswer(TimePoint now, std::int64_t sentTime);

    bool m_slow = false;
    Duration m_interval = kInterval;
    TimePoint m_next = kNever;
    std::array<std::int64_t, 16> m_sent{}; ///< ts1 of the unanswered requests; 0 = free
    std::size_t m_slot = 0;
};

} // namespace skyseal::vehicle
