// Detects known agents that announce themselves and do not answer: an agent is silent towards keys that it does not know, so
// the station has to detect this and report it. No clock and no I/O; updated about once a second.
#pragma once

#include "core/channel/session_info.h"
#include "core/engine/station/event.h"

#include <map>
#include <vector>

namespace skyseal::engine {

class UnansweringAgents
{
public:
    /// An answer takes one round trip, even over a radio; four unanswered messages in a row are not a coincidence.
    static constexpr Duration kPatience = std::chrono::seconds(3);
    static constexpr unsigned kLeastSent = 4;
    /// An agent announces itself every 500 ms; without an announcement for this long it is gone.
    static constexpr Duration kStillThere = std::chrono::seconds(3);

    explicit UnansweringAgents(std::string ownFingerprint) : m_ownFingerprint(std::move(ownFingerprint)) {}

    /// Returns the events to publish: agents that became unanswering, and those that are not any more.
    std::vector<AgentUnanswering> update(TimePoint now, const std::vector<channel::Unanswered> &attempts);
    std::vector<UnansweringAgent> all() const;

private:
    std::string m_ownFingerprint;
    std::map<channel::PublicKey, UnansweringAgent> m_agents;
};

} // namespace skyseal::engine
