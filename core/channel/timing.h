// Timers and limits of the protocol. The defaults are those of PROTOCOL.md, which gives the reason for each; tests shorten
// them.
#pragma once

#include "core/base/clock.h"

#include <cstdint>

namespace skyseal::channel {

struct Timing
{
    /// Interval of an agent's announcements while no session is up.
    Duration announceEvery = std::chrono::milliseconds(500);
    /// The same on a link that carries a session, while another listed peer has none.
    Duration announceBesideEvery = std::chrono::seconds(2);
    /// First retransmission of a first message; doubled for each further one, with jitter, up to 2 s.
    Duration handshakeRetry = std::chrono::milliseconds(250);
    /// A session sends at least one record in this time.
    Duration keepAliveAfter = std::chrono::seconds(1);
    /// A session without an authentic record for so long is silent: the station starts a new handshake beside it. An agent
    /// starts to announce itself earlier, after 1.5 x keepAliveAfter.
    Duration peerSilentAfter = std::chrono::milliseconds(2500);
    /// A session without an authentic record for so long ends (TimedOut).
    Duration forgetAfter = std::chrono::minutes(10);
    /// A switch that is not confirmed in this time is rolled back.
    Duration switchConfirm = std::chrono::seconds(5);
    Duration switchRetry = std::chrono::milliseconds(100);
    /// Lifetime of the read keys of the previous epoch, or 3 round trips if that is longer.
    Duration oldKeysLinger = std::chrono::seconds(3);
    Duration statsEvery = std::chrono::seconds(1);
    Duration rekeyAfter = std::chrono::seconds(600);
    std::uint32_t rekeyAfterRecords = 1u << 22;
    std::uint32_t hardStopRecords = (1u << 24) - 1;
};

} // namespace skyseal::channel
