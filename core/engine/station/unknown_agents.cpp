#include "core/engine/station/unknown_agents.h"

#include "core/link/address_text.h"

#include <algorithm>

namespace skyseal::engine {

bool UnknownAgents::note(TimePoint now, const Path &from)
{
    std::erase_if(m_agents, [now](const Entry &entry) { return now - entry.heard >= kReportAgain; });
    const auto known = std::find_if(m_agents.begin(), m_agents.end(), [&](const Entry &entry) { return entry.from == from; });
    if (known == m_agents.end()) {
        if (m_agents.size() < kMost)
            m_agents.push_back({from, now, now});
        return m_agents.back().from == from;
    }
    known->heard = now;
    const bool due = now - known->notified >= kReportAgain;
    if (due)
        known->notified = now;
    return due;
}

std::vector<UnknownAgent> UnknownAgents::all(TimePoint now) const
{
    std::vector<UnknownAgent> out;
    for (const Entry &entry : m_agents) {
        if (now - entry.heard < kStillThere)
            out.push_back({link::toText(entry.from.remote)});
    }
    return out;
}

} // namespace skyseal::engine
