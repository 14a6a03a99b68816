#include "core/engine/station/unanswering_agents.h"

#include "core/link/address_text.h"

#include <algorithm>

namespace skyseal::engine {

std::vector<AgentUnanswering> UnansweringAgents::update(TimePoint now, const std::vector<channel::Unanswered> &attempts)
{
    std::vector<AgentUnanswering> events;
    const auto isUnanswering = [now](const channel::Unanswered &attempt) {
        return attempt.sent >= kLeastSent && now - attempt.since >= kPatience && now - attempt.announced < kStillThere;
    };
    std::erase_if(m_agents, [&](const auto &entry) {
        const bool still = std::any_of(attempts.begin(), attempts.end(), [&](const channel::Unanswered &attempt) {
            return attempt.peer == entry.first && isUnanswering(attempt);
        });
        if (!still)
            events.push_back({entry.second, true});
        return !still;
    });
    for (const channel::Unanswered &attempt : attempts) {
        if (!isUnanswering(attempt))
            continue;
        const auto [entry, isNew] = m_agents.try_emplace(attempt.peer);
        entry->second = {attempt.peerName, link::toText(attempt.path.remote), m_ownFingerprint, seconds(now - attempt.since)};
        if (isNew)
            events.push_back({entry->second, false});
    }
    return events;
}

std::vector<UnansweringAgent> UnansweringAgents::all() const
{
    std::vector<UnansweringAgent> out;
    for (const auto &[key, agent] : m_agents)
        out.push_back(agent);
    return out;
}

} // namespace skyseal::engine
