// The parts that only a station with keys has: the secure channel, the pairing, and watches of sessions and agents. I/O thread.
#pragma once

#include "core/engine/common/channel_driver.h"
#include "core/engine/common/pairing_driver.h"
#include "core/engine/common/secret_files.h"
#include "core/engine/station/goodbye_repeater.h"
#include "core/engine/station/session_watches.h"
#include "core/engine/station/unanswering_agents.h"
#include "core/engine/station/unknown_agents.h"

#include <functional>

namespace skyseal::engine {

struct Snapshot;

struct StationChannel
{
    /// `secrets` and `links` must outlive this object.
    StationChannel(TimePoint now, const channel::Policy &policy, SecretFiles &secrets, LinkPool &links,
                   PairingDriver::Notify notify);

    channel::Endpoint &endpoint() { return driver.endpoint(); }
    const channel::Endpoint &endpoint() const { return driver.endpoint(); }

    /// Starts a switch of every session to this suite. Returns true if records arrive in at least one of them.
    bool switchAll(TimePoint now, crypto::SuiteId suite);
    /// Events for agents that have become unanswering, and for those that no longer are.
    std::vector<AgentUnanswering> updateUnanswering(TimePoint now);
    /// Call four times a second.
    void sampleQuarter();
    /// Call once a second.
    void sampleSecond();

    /// Fills in the sessions and agents of a snapshot.
    void describe(TimePoint now, Snapshot &out) const;

    ChannelDriver driver;
    PairingDriver pairing;
    SessionWatches sessions;
    UnansweringAgents unanswering;
    UnknownAgents unknownAgents;
    GoodbyeRepeater goodbyes; ///< of sessions that a measurement ended

private:
    SessionSnapshot describe(TimePoint now, const channel::SessionInfo &info) const;
};

} // namespace skyseal::engine
