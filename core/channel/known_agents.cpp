#include "core/channel/known_agents.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

/// An announcement or a cookie costs a hash or three for each peer that may have sent it, and strangers can send both. All such
/// hashes together take some percent of a core at most.
constexpr double kChecksPerSecond = 100'000;
constexpr double kChecksAtOnce = 10'000;

} // namespace

void KnownAgents::setPeers(const std::vector<Peer> &peers)
{
    m_agents.clear();
    for (const Peer &peer : peers)
        m_agents.push_back({peer.key, Announcement(peer.key)});
}

std::optional<PublicKey> KnownAgents::announcer(TimePoint now, const Path &from, ByteView datagram, EndpointCore &core)
{
    const auto isOf = [&](const Agent &agent) {
        ++core.strangerHashes;
        return agent.announcement.recognises(datagram);
    };
    unsigned free = kFreeChecks;
    for (const Agent &agent : m_agents) {
        if (free > 0 && agent.announcedFrom == from) {
            --free;
            if (isOf(agent))
                return agent.key;
        }
    }
    if (!mayCheck(now))
        return std::nullopt;
    const auto found = std::find_if(m_agents.begin(), m_agents.end(), isOf);
    spend(static_cast<double>(found - m_agents.begin()));
    if (found == m_agents.end()) {
        core.notifyRefused(now, from, RefusalReason::UnknownPeer);
        return std::nullopt;
    }
    found->announcedFrom = from;
    return found->key;
}

bool KnownAgents::mayCheck(TimePoint now)
{
    m_checks.fill(now, kChecksPerSecond, kChecksAtOnce);
    return m_checks.credit >= 1;
}

} // namespace skyseal::channel
