// The agents that a station lists, recognised by their announcements, and the limit of hashes for messages that any of them
// may have sent (PROTOCOL.md, section 3).
#pragma once

#include "core/channel/endpoint_core.h"
#include "core/channel/mac1.h"
#include "core/channel/token_bucket.h"

#include <optional>

namespace skyseal::channel {

class KnownAgents
{
public:
    void setPeers(const std::vector<Peer> &peers);

    /// The listed agent that made this announcement. nullopt if there is none, which is reported to the owner, or if too many
    /// announcements arrive.
    std::optional<PublicKey> announcer(TimePoint now, const Path &from, ByteView datagram, EndpointCore &core);
    /// Returns true if the limit allows a search for the sender of a message among all agents.
    bool mayCheck(TimePoint now);
    /// Charges the hashes of such a search.
    void spend(double hashes) { m_checks.credit -= hashes; }

private:
    struct Agent
    {
        PublicKey key{};
        Announcement announcement;
        std::optional<Path> announcedFrom{}; ///< of the latest announcement
    };

    std::vector<Agent> m_agents;
    TokenBucket m_checks;
};

/// Hashes for a message from an address where its sender was heard before, so that a flood does not crowd it out.
inline constexpr unsigned kFreeChecks = 2;

} // namespace skyseal::channel
