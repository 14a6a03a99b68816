// What an endpoint tells its owner: values, polled in the order in which they happened.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/policy.h"
#include "core/channel/session_id.h"
#include "core/channel/stats.h"

#include <string>
#include <variant>

namespace skyseal::channel {

/// A session is up: both ends have proven their keys. Sent once per handshake, also when a peer came back after a restart.
struct SessionUp
{
    SessionId session{};
    PublicKey peer{};
    std::string peerName;
    crypto::SuiteId suite{};
    Path path;
    Framing framing = Framing::Sealed; ///< Inline: both ends agreed to it; frames go so under the suites that can do it
};

enum class DownReason : std::uint8_t { PeerRestarted, PeerClosed, TimedOut, Exhausted, Revoked, Closed };

struct SessionDown
{
    SessionId session{};
    DownReason reason{};
    SessionStats stats;                ///< the last there will be
    Framing framing = Framing::Sealed; ///< as agreed
};

/// The peer's authenticated records now come from elsewhere.
struct PeerMoved
{
    SessionId session{};
    Path from;
    Path to;
};

struct SwitchPending
{
    SessionId session{};
    crypto::SuiteId from{};
    crypto::SuiteId to{};
    Epoch epoch{}; ///< the one that will be used
    bool byPeer = false;
    bool rekey = false; ///< same suite, fresh keys
};

enum class SwitchFailure : std::uint8_t { None, NotAllowedHere, NotAllowedByPeer, NotConfirmed, Superseded, SessionEnded };

/// Exactly one for each SwitchPending.
struct SwitchDone
{
    SessionId session{};
    crypto::SuiteId from{};
    crypto::SuiteId to{};
    Epoch epoch{};
    bool byPeer = false;
    bool rekey = false;
    SwitchFailure failure = SwitchFailure::None; ///< None = committed, otherwise rolled back
    Duration took{};
};

enum class RefusalReason : std::uint8_t {
    UnknownPeer, ///< a well-formed handshake or announcement of a key that nobody confirmed
    WrongKey,    ///< does not decrypt under our key: meant for somebody else, or an impostor
    ReplayedHandshake,
    NoCommonSuite,
    OfferTampered, ///< the choice is not the one that both offers give
    Version,
    /// An agent remembers a greater counter than ours: our file of counters was lost or put back. We go on from its number;
    /// when the event comes again, that could not be kept.
    CounterBehind,
    /// The station's key has used all handshake counters (2^40 - 1): it needs a new key.
    CountersUsedUp,
    Flood, ///< many first messages: strangers are asked to prove their address first. At most once in ten seconds
};

/// A handshake that was refused; limited to one a second and path, so that a flood cannot fill a log.
struct HandshakeRefused
{
    Path path;
    RefusalReason reason{};
    PublicKey peer{}; ///< zero when not known
};

/// Tags that did not verify came in since the last one of these; at most one a second and session.
struct ForgeryAlarm
{
    SessionId session{};
    std::uint64_t forged = 0;
    std::uint64_t replayed = 0;
};

using Event = std::variant<SessionUp, SessionDown, PeerMoved, SwitchPending, SwitchDone, HandshakeRefused, ForgeryAlarm>;

} // namespace skyseal::channel
