// Agents that announce themselves with a key that is not among the known peers. An announcement contains neither a key nor a
// fingerprint, and anybody can send one, so only its source address is known. No clock and no I/O; I/O thread.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/engine/station/unknown_agent.h"

#include <vector>

namespace skyseal::engine {

class UnknownAgents
{
public:
    /// An agent announces itself every 500 ms, of which one a second is noted here.
    static constexpr Duration kStillThere = std::chrono::seconds(4);
    /// An agent that keeps announcing itself is reported again after this time.
    static constexpr Duration kReportAgain = std::chrono::minutes(1);
    /// Greatest number of entries, so that forged announcements cause few events.
    static constexpr std::size_t kMost = 8;

    /// Notes an announcement of an unknown key. Returns true if it is to be reported.
    bool note(TimePoint now, const Path &from);
    /// The agents that still announce themselves, oldest first.
    std::vector<UnknownAgent> all(TimePoint now) const;

private:
    struct Entry
    {
        Path from;
        TimePoint notified, heard;
    };
    std::vector<Entry> m_agents;
};

} // namespace skyseal::engine
