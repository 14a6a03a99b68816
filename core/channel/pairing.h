// Pairing: two devices that do not know each other yet exchange their public keys, and two people say whether these are the
// right ones. A plain object without socket, thread or clock, beside the endpoint; PROTOCOL.md describes what it speaks.
// It lives as long as the window is open, and stores nothing: `Paired` is for the owner to keep.
//
//   station                                    agent
//     <- call                                    the window is open (twice a second, no key in it)
//     first ->  <- answer  third ->              Noise XXpsk3; nobody is shown before it is over
//     <- words ->                                "my person has not decided", "yes", "no", sealed, repeated
//
// Each person compares the full fingerprint on one screen with the one on the other; somebody in between has other keys.
// Poll the outputs after every input and command, as with an endpoint.
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
    std::string name;                                      ///< what we call ourselves
    PeerRole roleAsked = PeerRole::Pilot;                  ///< the station's: what it wants to be at the agent
    /// A slow hash of a passphrase that both people typed, for this one pairing; null = none. A second hurdle for somebody
    /// in between, who can guess at it at leisure: it does not replace the comparison of fingerprints.
    std::shared_ptr<const Key32> passphraseKey;
    bool wantPresharedKey = true; ///< a pre-shared key for the pair is made when both ends want one
    std::vector<Path> callTo;     ///< the agent's: where to call; an all-zero address is the one peer of a link
    Duration window = kPairingWindow;
};

/// Whom the person is to compare. Name and role are what the other end says of itself.
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

/// The person at the other end said yes, and ours has not yet.
struct PairingPeerConfirmed
{
    PublicKey key{};
};

enum class PairingGone : std::uint8_t {
    Silent,   ///< nothing for 10 s
    Refused,  ///< the person at the other end said no, or the window there closed
    Replaced, ///< it began again; PairingPeerSeen follows, and what was said is forgotten
};

/// The question that was asked is void.
struct PairingPeerGone
{
    PublicKey key{};
    PairingGone reason{};
};

/// Another device came through the handshake while one was being compared. At most one a second.
struct PairingOtherTried
{
    PairingPeer peer;
};

/// One end has a passphrase and the other none, or they differ. At most one a second; a hint that anybody can provoke.
struct PairingPassphraseDiffers
{};

/// Both people said yes: to be kept now. The system ids are empty; the pre-shared key is null unless both ends wanted one.
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
    /// True for a first byte of this protocol's pairing messages; an endpoint owns these as well, so ask here first.
    static bool owns(std::uint8_t firstByte);
    const PairingPeer *peer() const; ///< whom the person is asked about; null when nobody is there
    bool confirmedHere() const;
    bool confirmedThere() const;
    /// Over, and the other end was told as well as could be.
    bool finished() const;
    TimePoint nextDeadline() const;

    // input
    void handleDatagram(TimePoint now, const Path &from, ByteView datagram);
    void handleDeadline(TimePoint now);

    // command
    /// The person said yes to the key that was looked at. Ignored for any other than the one of `peer()`.
    void confirm(TimePoint now, const PublicKey &key);
    /// The one shown is the wrong one: it is told, and set aside while the window stays open for others.
    void refuse(TimePoint now);
    /// Closes the window. After both ends confirmed it changes nothing.
    void cancel(TimePoint now, PairingEnd reason = PairingEnd::Cancelled);

    // output
    std::optional<Transmit> pollTransmit();
    std::optional<PairingEvent> pollEvent();

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace skyseal::channel
