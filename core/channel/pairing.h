// Pairing: two devices that do not know each other exchange their public keys, and two people confirm that these are the right
// ones (PROTOCOL.md, section 13). A plain object without socket, thread or clock, beside the endpoint. It lives as long as the
// pairing window is open, and stores nothing: the owner stores the result from the event `Paired`.
//
//   station                                    agent
//     <- call                                    the window is open (twice a second, no key in it)
//     first ->  <- answer  third ->              Noise XXpsk3; no peer is shown before it has finished
//     <- words ->                                the decision of each person, sealed and repeated
//
// Each person compares the full fingerprints on both screens; a man in the middle has other keys.
// Poll the outputs after each input and command, as with an endpoint.
#pragma once

#include "core/base/bytes.h"
#include "core/base/clock.h"
#include "core/base/path.h"
#include "core/base/random_source.h"
#include "core/channel/delivery.h"
#include "core/channel/policy.h"
#include "core/channel/role.h"
#include "core/crypto/x25519.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>

namespace skyseal::channel {

inline constexpr Duration kPairingWindow = std::chrono::seconds(120);
inline constexpr std::size_t kMaxPairingName = 24; ///< bytes; longer ones are cut between characters

struct PairingConfig
{
    Role role = Role::Station;
    std::shared_ptr<const crypto::X25519KeyPair> identity; ///< our static key
    std::string name;                                      ///< our name for the other end
    PeerRole roleAsked = PeerRole::Pilot;                  ///< a station's: role that it asks for at the agent
    /// Slow hash of a passphrase that both people typed, for this pairing only; null = none. An additional obstacle to a man in
    /// the middle, who can guess at it offline: it does not replace the comparison of fingerprints.
    std::shared_ptr<const Key32> passphraseKey;
    bool wantPresharedKey = true; ///< a pre-shared key for the pair is made when both ends want one
    std::vector<Path> callTo;     ///< an agent's: targets of its calls; an all-zero address is the only peer of a link
    Duration window = kPairingWindow;
};

/// The peer to confirm. Name and role are claims of the other end.
struct PairingPeer
{
    PublicKey key{};
    std::string name;
    PeerRole roleAsked = PeerRole::Pilot;
    Path path;
};

/// Show both fingerprints; then confirm(peer.key) or refuse().
struct PairingPeerSeen
{
    PairingPeer peer;
};

/// The person at the other end has confirmed, ours has not yet.
struct PairingPeerConfirmed
{
    PublicKey key{};
};

enum class PairingGone : std::uint8_t {
    Silent,   ///< nothing for 10 s
    Refused,  ///< the person at the other end refused, or the window there closed
    Replaced, ///< it started again; PairingPeerSeen follows, earlier decisions are void
};

/// The peer shown before is gone; its question is void.
struct PairingPeerGone
{
    PublicKey key{};
    PairingGone reason{};
};

/// Another device finished the handshake while one was shown. At most one event a second.
struct PairingOtherTried
{
    PairingPeer peer;
};

/// The passphrases differ, or one end has none. At most one event a second; an unauthenticated hint.
struct PairingPassphraseDiffers
{};

/// Both people confirmed: store the peer. It has no system ids; the pre-shared key is null unless both ends wanted one.
struct Paired
{
    Peer peer;
};

enum class PairingEnd : std::uint8_t { Paired, TimedOut, Cancelled, Armed };

/// The last event, exactly one.
struct PairingOver
{
    PairingEnd reason{};
};

using PairingEvent = std::variant<PairingPeerSeen, PairingPeerConfirmed, PairingPeerGone, PairingOtherTried,
                                  PairingPassphraseDiffers, Paired, PairingOver>;

class Pairing
{
public:
    /// Opens the window. `random` must outlive it.
    Pairing(PairingConfig config, RandomSource &random, TimePoint now);
    ~Pairing();
    Pairing(Pairing &&) noexcept;
    Pairing &operator=(Pairing &&) noexcept;

    // query
    /// Returns true for the first byte of a pairing message. Endpoint::owns() is true for it as well, so ask here first.
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
    /// The person confirmed this key. Ignored unless it is that of peer().
    void confirm(TimePoint now, const PublicKey &key);
    /// The person refused the peer that is shown: it is notified and ignored, while the window stays open for others.
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
