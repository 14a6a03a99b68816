// Parts of an endpoint that both roles share: configuration, session table, counters and refusal events.
#pragma once

#include "core/channel/counter_store.h"
#include "core/channel/endpoint_config.h"
#include "core/channel/handshake.h"
#include "core/channel/interval_limit.h"
#include "core/channel/mac1.h"
#include "core/channel/session_table.h"

namespace skyseal::channel {

/// Returns true if both are the same secret, or both are null.
bool samePresharedKey(const std::shared_ptr<const Key32> &one, const std::shared_ptr<const Key32> &other);

struct EndpointCore
{
    EndpointCore(Config configuration, RandomSource &random, CounterStore &store);

    const Peer *peer(const PublicKey &key) const;
    /// Notifies the owner of a refused handshake, at most once a second for each reason that a stranger can cause, and once a
    /// second and path for the others, and for agents that are not listed. Does not count it.
    void notifyRefused(TimePoint now, const Path &path, RefusalReason reason, const PublicKey &key = {});
    /// Sets the offer of the context to the suites and framings of our policy that this machine provides.
    void updateOffer();
    /// Makes the session the one with its peer and notifies the owner. An earlier session with the peer ends (PeerRestarted).
    void bringUp(TimePoint now, SessionTable::Entry &entry);
    void end(TimePoint now, Session &session, DownReason reason);
    /// Ends the sessions that have finished.
    void endFinished(TimePoint now);

    Config config;
    CounterStore &counters;
    SessionContext context;
    SessionTable table;
    ReceiveCounters unmatched;
    Mac1 ownMac;
    std::uint64_t strangerHashes = 0;

private:
    struct Notified
    {
        Path path;
        TimePoint at{};
    };
    // One for each reason, so that a flood of one kind hides no other.
    std::vector<IntervalLimit> m_strangerEvents;
    // A flood from many addresses shares a few slots, so that it fills neither memory nor the owner's log.
    using Notices = std::array<std::optional<Notified>, 8>;
    Notices m_unknownAgents, m_otherRefusals;
};

} // namespace skyseal::channel
