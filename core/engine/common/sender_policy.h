// Decides which senders of MAVLink are trusted: the system ids that an authenticated peer may use, and whether clear frames
// are accepted at all. No I/O and no clock; consulted for every frame.
#pragma once

#include "core/base/clock.h"
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

/// A vehicle has one agent. Stations may share system ids: several may use the customary 255, and a station that replaces a
/// crashed one must not have to wait until the session of the crashed one times out.
enum class Speakers : std::uint8_t { OnePerSystem, MayShareASystem };

class SenderPolicy
{
public:
    explicit SenderPolicy(SecureMode mode, Speakers speakers = Speakers::OnePerSystem) : m_mode(mode), m_rule(speakers) {}

    SecureMode mode() const { return m_mode; }
    void setMode(SecureMode mode) { m_mode = mode; }

    /// A peer that the list binds to no system may use this many ids, the first ones that it uses, until it is removed from the
    /// list: an autopilot, a second one, a camera or gimbal with a separate id, and a station beside them. With more, a single
    /// rogue agent could take all ids.
    static constexpr std::size_t kMostUnbound = 4;
    /// An id that is not bound by the list stays reserved for its peer for this time after its session: as long as a session
    /// survives silence, so that no other agent takes the place of a vehicle behind a hill. After that another agent may use
    /// it, so that none is locked out for ever.
    static constexpr Duration kClaimOutlivesSession = std::chrono::minutes(10);

    /// Sets the known peers. System ids that are bound to one of them are not accepted in clear.
    void setPeers(const std::vector<channel::Peer> &peers);
    /// Adds the system ids that peers used over sealed links in earlier runs: neither a broken sealed link nor a restart may
    /// cause clear frames of these systems to be accepted. Entries of peers that are not in the list are ignored.
    void rememberSealed(const SealedSystems &heard);
    const SealedSystems &sealedSystems() const { return m_heard; }
    void sessionUp(channel::SessionId session, const channel::PublicKey &peer, const Path &path);
    void sessionMoved(channel::SessionId session, const Path &path);
    void sessionDown(channel::SessionId session);

    /// Whether all messages of the peer may reach an autopilot. False for observers.
    bool mayCommand(channel::SessionId session) const;
    /// Whether a peer that may command has a session.
    bool pilotThere() const;
    /// Whether the list binds the system to a peer that may command, or such a peer has used it.
    bool isPilotsSystem(std::uint8_t systemId) const;
    /// Whether a sealed frame of this session may have this system id. A system that the list binds to peers is reserved for
    /// them; with Speakers::OnePerSystem any other belongs to the first peer that used it sealed, until that peer is removed
    /// from the list or its claim ends, see endClaims(). A peer that is bound to none has at most kMostUnbound.
    bool acceptSealed(channel::SessionId session, std::uint8_t systemId);
    /// Whether a system that acceptSealed() does not accept from this session belongs to another peer, so that its frames may
    /// be an impersonation. If not, it belongs to nobody: another system that an autopilot or a radio forwards.
    bool belongsToAnother(std::uint8_t systemId, channel::SessionId asker) const;
    /// Ends the claims of peers that had no session for kClaimOutlivesSession. Call about once a second. Clear frames of these
    /// systems remain refused.
    void endClaims(TimePoint now);
    /// The name of another peer to which the system belongs; empty if there is none.
    std::string ownerOf(std::uint8_t systemId, channel::SessionId asker) const;

    /// Whether a clear frame may be shown: always with SecureMode::Off, which the operator chose. Otherwise not if sealing is
    /// required, not for a system that is bound to a peer or was ever used sealed, not from the address of a session, and
    /// not while it needs approval.
    bool acceptClear(const Path &from, std::uint8_t systemId) const;
    /// Whether only the operator's approval is missing. A peer that is bound to no system and was never heard sealed may have
    /// any system id: an attacker who blocks its handshakes from the start could offer another vehicle in clear instead.
    bool needsApproval(const Path &from, std::uint8_t systemId) const;
    /// The names of the peers that make approval necessary: bound to no system and never heard sealed.
    std::string neverHeard() const;
    /// The operator accepts the system in clear, until it is heard sealed or this object is destroyed.
    void allowPlaintext(std::uint8_t systemId) { m_allowed.set(systemId); }
    /// The session whose records come from this address.
    std::optional<channel::SessionId> sessionAt(const Path &path) const;
    /// Whether a known peer had a session at this address in this run.
    bool sealedSpokeAt(const Path &path) const;
    bool knowsAnybody() const { return !m_peers.empty(); }
    /// The session to which a refused clear frame is charged: the one at this address, or the one that uses the system id.
    std::optional<channel::SessionId> sessionConcerned(const Path &from, std::uint8_t systemId) const;
    /// Whether clear frames of the system are refused because it is known to be sealed.
    bool isSealedSystem(std::uint8_t systemId) const { return m_sealed.test(systemId) || m_pinned.test(systemId); }

private:
    struct Speaker
    {
        channel::PublicKey peer{};
        Path path;
        bool pilot = false;
        std::bitset<256> bound;   ///< system ids bound to the peer by the list
        std::bitset<256> allowed; ///< system ids that the list permits
        std::bitset<256> spoken;  ///< system ids that were used: a cache of acceptSealed()
    };

    struct SealedPlace
    {
        channel::PublicKey peer{};
        Path path;
    };
    static constexpr std::size_t kMostPlaces = 64; ///< of peers whose address changes; the oldest is dropped first

    void applyRules(Speaker &speaker) const;
    const channel::Peer *holderOf(std::uint8_t systemId, const channel::PublicKey &except) const;
    void noteSealedAt(const channel::PublicKey &peer, const Path &path);
    void collectSealed();
    bool mayBeClear(const Path &from, std::uint8_t systemId) const;
    bool hasAllItsSystems(const Speaker &speaker) const;
    bool mayHaveAnySystem(const channel::Peer &peer) const;

    SecureMode m_mode;
    Speakers m_rule;
    std::vector<channel::Peer> m_peers;
    std::bitset<256> m_pinned;
    SealedSystems m_heard;
    /// Peers whose unbound systems are reserved, and the end of the reservation: nullopt while they have a session.
    std::map<channel::PublicKey, std::optional<TimePoint>> m_claims;
    std::bitset<256> m_sealed;  ///< all of m_heard
    std::bitset<256> m_allowed; ///< in clear, by the operator
    std::map<channel::SessionId, Speaker> m_speakers;
    std::deque<SealedPlace> m_sealedPlaces;
};

} // namespace skyseal::engine
