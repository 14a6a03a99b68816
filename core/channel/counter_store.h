// Persistent handshake counters. A first message carries a counter that must never go back, so that an agent can refuse a
// replayed one (PROTOCOL.md, section 4). The owner of an endpoint implements this interface, usually with a file.
#pragma once

#include "core/base/reason.h"
#include "core/channel/policy.h"

#include <cstdint>
#include <optional>
#include <string>

namespace skyseal::channel {

/// Called on the thread of the endpoint, rarely: once for each handshake.
class CounterStore
{
public:
    virtual ~CounterStore() = default;
    /// Returns a counter greater than every earlier one, across restarts; nullopt if none is available yet. Must not wait
    /// for the disk: strangers can cause calls.
    virtual std::optional<std::uint64_t> next() = 0;
    /// Makes next() return counters greater than `counter` from then on. Returns false if that takes a while, or fails; next()
    /// then returns nullopt meanwhile.
    virtual bool skipTo(std::uint64_t counter)
    {
        static_cast<void>(counter);
        return false;
    }
    /// Returns the greatest counter accepted from `peer`, 0 if there is none.
    virtual std::uint64_t lastSeen(const PublicKey &peer) = 0;
    /// Keeps the counter, over restarts as soon as it is stored. If it returns false, the endpoint refuses the session.
    virtual bool remember(const PublicKey &peer, std::uint64_t counter) = 0;
    /// Returns why the counters are not stored at present, for people; empty if they are. An agent reports it to its stations.
    virtual Reason problem() const { return {}; }
};

} // namespace skyseal::channel
