// Whose MAVLink is believed: which system ids a sealed peer may speak as, and whether clear frames are taken at all. No
// I/O and no clock; the station asks it for every frame.
#pragma once

#include "core/base/path.h"
#include "core/channel/events.h"
#include "core/channel/policy.h"
#include "core/engine/common/sealed_systems.h"
#include "core/engine/common/secure_mode.h"

#include <array>
#include <bitset>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::engine {

/// A vehicle has one agent. Stations share: several may speak as the customary system 255, and one that takes over from
/// another that crashed must not wait until the crashed one's session is forgotten.
enum class Speakers : std::uint8_t { OnePerSystem, MayShareASystem };

class SenderPolicy
{
public:
    explicit SenderPolicy(SecureMode mode, Speakers speakers = Speakers::OnePerSystem) : m_mode(mode), m_rule(speakers) {}

    SecureMode mode() const { return m_mode; }
    void setMode(SecureMode mode) { m_mode = mode; }

    /// The known peers: the system ids that they are bound to are never again taken in clear.
    void setPeers(const std::vector<channel::Peer> &peers);
    /// The systems that peers were heard to speak as, sealed, by earlier runs as well: cutting the sealed link, or a
    /// restart, must not open the way for clear frames in their name. Those of peers that are no longer known do not count.
    void rememberSealed(const SealedSystems &heard);
    const SealedSystems &sealedSystems() const { return m_heard; }
    void sessionUp(channel::SessionId session, const channel::PublicKey &peer, const Path &path);
    void sessionMoved(channel::SessionId session, const Path &path);
    void sessionDown(channel::SessionId session);

    /// What it sends may reach an autopilot, whatever it is. False for observers.
    bool mayCommand(channel::SessionId session) const;
    /// A peer that may command has a session.
    bool pilotThere() const;
    /// Whether a frame that came sealed may speak as this system id. A system that is bound to peers by the list is theirs
    /// alone; with Speakers::OnePerSystem any other belongs to the first peer that was ever heard sealed as it, until that
    /// one is taken off the list: while a vehicle is silent no other agent can take its place.
    bool acceptSealed(channel::SessionId session, std::uint8_t systemId);
    /// The name of another peer to which the system belongs; empty when there is none.
    std::string ownerOf(std::uint8_t systemId, channel::SessionId asker) const;

    /// Whether a clear frame may be shown: every one with SecureMode::Off, which a person chose. Otherwise not when sealing
    /// is required, not for a system that is bound to a peer or was ever heard sealed, not from the very place where a
    /// session's records come from, and not while it is held back.
    bool acceptClear(const Path &from, std::uint8_t systemId) const;
    /// Whether nothing but a person's word is missing. A peer that is bound to no system and was never heard sealed may have
    /// any: whoever blocks its handshakes from the start could offer another vehicle, in clear, in its place.
    bool needsApproval(const Path &from, std::uint8_t systemId) const;
    /// The peers for whose sake that is so: their names.
    std::string neverHeard() const;
    /// A person takes the system in clear, for as long as this object lives and it is not heard sealed.
    void allowPlaintext(std::uint8_t systemId) { m_allowed.set(systemId); }
    /// The session whose records come from there.
    std::optional<channel::SessionId> sessionAt(const Path &path) const;
    /// Whether a known peer's session was ever there, in this run.
    bool sealedSpokeAt(const Path &path) const;
    bool knowsAnybody() const { return !m_peers.empty(); }
    /// The session to which a refused clear frame is to be charged: the one at that place, or the one that speaks as the
    /// system.
    std::optional<channel::SessionId> sessionConcerned(const Path &from, std::uint8_t systemId) const;
    /// True when clear frames of the system are refused because it is known to be sealed.
    bool isSealedSystem(std::uint8_t systemId) const { return m_sealed.test(systemId) || m_pinned.test(systemId); }

private:
    struct Speaker
    {
        channel::PublicKey peer{};
        Path path;
        bool pilot = false;
        std::bitset<256> bound;   ///< to it, by the list of peers
        std::bitset<256> allowed; ///< by the same
        std::bitset<256> spoken;  ///< as what it has spoken: checked once, then cheap
    };

    struct SealedPlace
    {
        channel::PublicKey peer{};
        Path path;
    };
    static constexpr std::size_t kMostPlaces = 64; ///< of peers that move about; the oldest is forgotten first

    void applyRules(Speaker &speaker) const;
    const channel::Peer *holderOf(std::uint8_t systemId, const channel::PublicKey &except) const;
    void noteSealedAt(const channel::PublicKey &peer, const Path &path);
    void collectSealed();
    bool mayBeClear(const Path &from, std::uint8_t systemId) const;
    bool mayHaveAnySystem(const channel::Peer &peer) const;

    SecureMode m_mode;
    Speakers m_rule;
    std::vector<channel::Peer> m_peers;
    std::bitset<256> m_pinned;
    SealedSystems m_heard;
    std::bitset<256> m_sealed;  ///< all of m_heard
    std::bitset<256> m_allowed; ///< in clear, by a person
    std::map<channel::SessionId, Speaker> m_speakers;
    std::deque<SealedPlace> m_sealedPlaces;
};

} // namespace skyseal::engine
