// Which known agents are there and do not answer: an agent is silent towards keys that it does not know, so the station has
// to notice by itself and say so instead of waiting for ever. No clock and no I/O; asked about once a second.
#pragma once

#include "core/channel/session_info.h"
#include "core/engine/station/event.h"

#include <map>
#include <vector>

namespace skyseal::engine {

class UnansweringAgents
{
public:
    /// An answer takes a round trip, also over a radio; four messages are not lost by accident.
    static constexpr Duration kPatience = std::chrono::seconds(3);
    static constexpr unsigned kLeastSent = 4;
    /// An agent announces itself every 500 ms; one that was not heard for so long is gone rather than silent.
    static constexpr Duration kStillThere = std::chrono::seconds(3);

    explicit UnansweringAgents(std::string ownFingerprint) : m_ownFingerprint(std::move(ownFingerprint)) {}

    /// What is to be told: agents that begin to be unanswering, and those that no longer are.
    std::vector<AgentUnanswering> update(TimePoint now, const std::vector<channel::Unanswered> &attempts);
    std::vector<UnansweringAgent> all() const;

private:
    std::string m_ownFingerprint;
    std::map<channel::PublicKey, UnansweringAgent> m_agents;
};

} // namespace skyseal::engine
