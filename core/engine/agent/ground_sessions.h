// The sessions of an agent that are up, and for each the loss of the station's frames by their sequence numbers. The station
// cannot know which of its frames were lost before or after the channel, so it receives these counts with the next report.
// No I/O and no clock.
#pragma once

#include "core/channel/events.h"
#include "core/mavlink/frame.h"
#include "core/metrics/sequence_table.h"

#include <map>
#include <vector>

namespace skyseal::engine {

class GroundSessions
{
public:
    void add(channel::SessionId session) { m_all.push_back(session); }
    void remove(channel::SessionId session)
    {
        std::erase(m_all, session);
        m_received.erase(session);
    }

    bool none() const { return m_all.empty(); }
    /// In the order in which they came up.
    const std::vector<channel::SessionId> &all() const { return m_all; }

    /// Counts a frame of the station. Returns the sums over its session.
    channel::FrameCounters note(TimePoint now, channel::SessionId session, const mavlink::Frame &frame)
    {
        metrics::SequenceTable &table = m_received[session];
        // Without the link: a session may move to another modem, and its frames continue one sequence.
        table.note({LinkId{}, frame.systemId(), frame.componentId()}, frame.sequence(), now);
        const metrics::SequenceCounts counts = table.total();
        return {counts.received - counts.duplicate, counts.lost};
    }

private:
    std::vector<channel::SessionId> m_all;
    std::map<channel::SessionId, metrics::SequenceTable> m_received;
};

} // namespace skyseal::engine
