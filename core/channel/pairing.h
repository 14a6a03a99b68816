// Pairing: two devices that do not know each other exchange their public keys, and two people confirm that these are the right
// ones (PROTOCOL.md, section 13). A plain object without socket, thread or clock, beside the endpoint. It lives as long as the
// pairing window is open, and stores nothing: the owner stores the result from the event `Paired`.
//
//   station                                    agent
//     request ->                                 only to an agent that listens, on its listening links
//     <- call                                    the window is open (twice a second, no key in it)
//     first ->      <- answer                    shares of CPace, and the agent's commitment to its opening
//     opening ->    <- opening                   keys, names and nonces: once in a window
//     <- words ->                                the decision of each person, sealed and repeated
//
// Without a passphrase both people compare the code; a man in the middle makes two codes agree once in a million attempts, and
// has one attempt in a window. With a passphrase he has one guess at the station's window and three at the agent's.
// Poll the outputs after each input and command, as with an endpoint.
#pragma once

#include "core/base/bytes.h"
#include "core/base/random_source.h"
#include "core/channel/delivery.h"
#include "core/channel/pairing_config.h"
#include "core/channel/policy.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace skyseal::channel {

/// The peer to confirm. Name and system id are claims of the other end.
struct PairingPeer
{
    PublicKey key{};
    std::string name;
    std::uint8_t systemId = 0; ///< its MAVLink system id, an agent's vehicle's; 0 = unknown
    std::string code;          ///< "123 456", the same at the other end; to be compared unless there is a passphrase
    Path path;
};

/// The other end has proved that it holds the private key, and knows the passphrase if there is one. Show the code and the
/// peer; then confirm(peer.key) or refuse().
struct PairingPeerSeen
{
    PairingPeer peer;
};

/// The person at the other end has confirmed, ours has not yet.
struct PairingPeerConfirmed
{
    PublicKey key{};
};

/// Another device began a handshake with this agent after the one that is shown. Unauthenticated; at most one event a second.
struct PairingOtherTried
{};

/// The passphrases differ, or one end has none. At most one event a second; an unauthenticated hint.
struct PairingPassphraseDiffers
{};

/// Both people confirmed: store the peer, with its pre-shared key and the system id that was shown.
struct Paired
{
    Peer peer;
};

enum class PairingEnd : std::uint8_t {
    Paired,
    TimedOut,
    Cancelled,
    Armed,
    Refused,      ///< by the person here
    RefusedThere, ///< by the person at the other end, or the window there closed
    Interrupted,  ///< the other end did not continue after our opening; the next attempt needs a new window
    Guessed,      ///< three wrong passphrases: they differ, or an attacker guesses
};

/// The last event, exactly one.
struct PairingOver
{
    PairingEnd reason{};
};

using PairingEvent =
    std::variant<PairingPeerSeen, PairingPeerConfirmed, PairingOtherTried, PairingPassphraseDiffers, Paired, PairingOver>;

class Pairing
{
public:
    /// Opens the window. `random` must outlive it.
    Pairing(PairingConfig config, RandomSource &random, TimePoint now);
    ~Pairing();
    Pairing(Pairing &&) noexcept;
    Pairing &operator=(Pairing &&) noexcept;

    // query
    /// Returns true for the first byte of a pairing message. Endpoint::owns() is true for it as well, so check this first.
    static bool owns(std::uint8_t firstByte);
    const PairingPeer *peer() const; ///< the peer that is shown; null if there is none
    bool confirmedHere() const;
    bool confirmedThere() const;
    /// Pairing is over, and the repetitions to the other end are done.
    bool finished() const;
    TimePoint nextDeadline() const;

    // input
    void handleDatagram(TimePoint now, const Path &from, ByteView datagram);
    void handleDeadline(TimePoint now);

    // command
    /// Replaces PairingConfig::callTo.
    void setCallTo(std::vector<Path> paths);
    /// The person confirmed this key. Ignored unless it is that of peer().
    void confirm(TimePoint now, const PublicKey &key);
    /// The person refused the peer that is shown: closes the window, and notifies the other end.
    void refuse(TimePoint now);
    /// Closes the window. No effect once both ends have confirmed.
    void cancel(TimePoint now, PairingEnd reason = PairingEnd::Cancelled);

    // output
    std::optional<Transmit> pollTransmit();
    std::optional<PairingEvent> pollEvent();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace skyseal::channel
