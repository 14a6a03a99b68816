// State of sessions and handshakes as an endpoint reports it to its owner.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/policy.h"
#include "core/channel/session_id.h"
#include "core/channel/stats.h"

#include <optional>
#include <string>
#include <vector>

namespace skyseal::channel {

struct SessionInfo
{
    SessionId session{};
    PublicKey peer{};
    std::string peerName;
    PeerRole role{};
    Path path;
    crypto::SuiteId suite{};
    Epoch epoch{};
    Framing framing{};                        ///< of the frames sent
    std::optional<crypto::SuiteId> pending;   ///< target of a switch in progress
    std::vector<crypto::SuiteId> permitted;   ///< by both ends
    std::vector<crypto::SuiteId> peerOffered; ///< by the peer in the handshake; contains None if it allows plain MAVLink
    bool silent = false;                      ///< no authentic record for Timing::peerSilentAfter
    TimePoint since{};
    TimePoint lastReceived{};
};

/// A known agent that announces itself and does not answer the handshake, for instance because it does not list our key.
struct Unanswered
{
    PublicKey peer{};
    std::string peerName;
    Path path;             ///< source of its latest announcement
    TimePoint since{};     ///< of the first message without an answer
    TimePoint announced{}; ///< time of its latest announcement
    unsigned sent = 0;     ///< first messages sent
};

} // namespace skyseal::channel
