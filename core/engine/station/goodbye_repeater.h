// Repeats the goodbyes (Close messages) of sessions that a measurement ended. A goodbye is sent once and may be lost. A peer
// that still sends records has not received it, and would not send clear MAVLink until the session times out. The same datagram
// is sent again, so that a peer that has received it rejects it as a replay. No I/O and no clock.
#pragma once

#include "core/engine/common/channel_driver.h"

#include <vector>

namespace skyseal::engine {

class GoodbyeRepeater
{
public:
    /// Records that arrive within this time were already in transit and do not show that the goodbye was lost.
    static constexpr Duration kPause = std::chrono::milliseconds(250);

    void set(TimePoint now, std::vector<ChannelDriver::Goodbye> goodbyes)
    {
        m_goodbyes = std::move(goodbyes);
        m_again = now + kPause;
    }

    /// Call for each record that arrives although no session is wanted; calls `send(const Path &, ByteView)` for the goodbyes
    /// of its path, at most four times a second.
    template<typename Send> void recordArrived(TimePoint now, const Path &from, Send &&send)
    {
        if (now < m_again)
            return;
        for (const ChannelDriver::Goodbye &goodbye : m_goodbyes) {
            if (goodbye.to != from)
                continue;
            send(goodbye.to, ByteView(goodbye.datagram));
            m_again = now + kPause;
        }
    }

private:
    std::vector<ChannelDriver::Goodbye> m_goodbyes;
    TimePoint m_again{};
};

} // namespace skyseal::engine
