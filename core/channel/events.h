// Events of an endpoint for its owner: values, polled in the order in which they occurred.
#pragma once

#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/channel/policy.h"
#include "core/channel/session_id.h"
#include "core/channel/stats.h"

#include <string>
#include <variant>

namespace skyseal::channel {

/// A session is up: both ends have proven their keys. Once per handshake, also when a peer has restarted.
struct SessionUp
{
    SessionId session{};
    PublicKey peer{};
    std::string peerName;
    crypto::SuiteId suite{};
    Path path;
    Framing framing = Framing::Sealed; ///< Inline: agreed by both ends; used under the suites that have it
};

enum class DownReason : std::uint8_t {
    PeerRestarted,
    PeerClosed,
    TimedOut,
    Exhausted,
    Revoked,
    Closed,
    Cloned ///< the keys of one end are in use twice: see recent_tags.h
};

struct SessionDown
{
    SessionId session{};
    DownReason reason{};
    SessionStats stats;                ///< final
    Framing framing = Framing::Sealed; ///< as agreed
};

/// The peer's authenticated records come from another path.
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
    Epoch epoch{}; ///< the next epoch
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
    UnknownPeer, ///< a valid handshake, or an announcement, of a key that is not listed
    WrongKey,    ///< does not decrypt under our key: for another device, or forged
    ReplayedHandshake,
    NoCommonSuite,
    OfferTampered, ///< the chosen suite does not follow from both offers
    Version,
    /// An agent remembers a greater counter than ours: our counter file was lost or restored from a copy. We continue from its
    /// number; if the event repeats, the number could not be stored.
    CounterBehind,
    /// The station's key has used all handshake counters (2^40 - 1): it needs a new key.
    CountersUsedUp,
    Flood, ///< many first messages: unknown senders must prove their address. At most once in ten seconds
};
constexpr std::size_t kRefusalReasons = static_cast<std::size_t>(RefusalReason::Flood) + 1;

/// Returns true if messages of senders that are not authenticated, or copies of old messages, lead to this refusal. Flood is
/// not among them: it has a limit of its own.
bool isCausedByStrangers(RefusalReason reason);

/// A refused handshake, so limited that a flood cannot fill a log: at most one event a second of each reason that strangers
/// cause, and of the others one a second and path.
struct HandshakeRefused
{
    Path path;
    RefusalReason reason{};
    PublicKey peer{}; ///< zero if not known
};

/// Records with a wrong tag arrived since the last alarm. At most one event a second and session.
struct ForgeryAlarm
{
    SessionId session{};
    std::uint64_t forged = 0;
    std::uint64_t replayed = 0;
};

/// Frames of ours reached the agent too late to be obeyed. At most one event for each of its reports, about once a second.
struct CommandsLate
{
    SessionId session{};
    std::uint64_t records = 0; ///< since the last such event
    FreshnessReport report;
};

/// The agent cannot store the counters of handshakes any more, or it can again.
struct PeerStorageChanged
{
    SessionId session{};
    bool failed = false;
};

using Event = std::variant<SessionUp, SessionDown, PeerMoved, SwitchPending, SwitchDone, HandshakeRefused, ForgeryAlarm,
                           CommandsLate, PeerStorageChanged>;

} // namespace skyseal::channel
