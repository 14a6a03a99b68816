// What both roles of an endpoint share: its sessions, whom it knows, and how it tells about either.
#pragma once

#include "core/channel/counter_store.h"
#include "core/channel/endpoint_config.h"
#include "core/channel/handshake.h"
#include "core/channel/mac1.h"
#include "core/channel/session_table.h"

namespace skyseal::channel {

/// Of two peers or attempts: the same secret, or none for both.
bool samePresharedKey(const std::shared_ptr<const Key32> &one, const std::shared_ptr<const Key32> &other);

struct EndpointCore
{
    EndpointCore(Config configuration, RandomSource &random, CounterStore &store);

    const Peer *peer(const PublicKey &key) const;
    /// Counts nothing; tells the owner, at most once a second and path.
    void tellRefused(TimePoint now, const Path &path, RefusalReason reason, const PublicKey &key = {});
    /// What our policy offers, and this build can do.
    void offerPolicy();
    /// The session becomes the one with its peer: an earlier one ends as PeerRestarted.
    void bringUp(TimePoint now, SessionTable::Entry &entry);
    void end(TimePoint now, Session &session, DownReason reason);
    /// Ends those sessions that cannot go on.
    void reap(TimePoint now);

    Config config;
    CounterStore &counters;
    Surroundings around;
    SessionTable table;
    ReceiveCounters unmatched;
    Mac1 ownMac;

private:
    struct Told
    {
        Path path;
        TimePoint at{};
    };
    // A flood from many addresses shares these few slots, so that it can neither fill memory nor the owner's log.
    std::array<std::optional<Told>, 8> m_notified;
};

} // namespace skyseal::channel
