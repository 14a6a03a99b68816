// Agents that announce themselves here with a key that nobody confirmed. An announcement shows neither a key nor a
// fingerprint, and anybody can send one: where it came from is all that is known. No clock and no I/O; I/O thread.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/engine/station/snapshot.h"

#include <vector>

namespace skyseal::engine {

class UnknownAgents
{
public:
    /// An agent announces itself every 500 ms, of which one a second is noted here.
    static constexpr Duration kStillThere = std::chrono::seconds(4);
    /// One that goes on is told again after so long.
    static constexpr Duration kTellAgain = std::chrono::minutes(1);
    /// Whoever forges many of them gets few words.
    static constexpr std::size_t kMost = 8;

    /// An announcement that no known key made. True when it is to be told.
    bool note(TimePoint now, const Path &from);
    /// Those that are there, the first one first.
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
