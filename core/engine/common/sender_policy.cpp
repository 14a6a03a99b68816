#include "core/engine/common/sender_policy.h"

#include <algorithm>

namespace skyseal::engine {

void SenderPolicy::setPeers(const std::vector<channel::Peer> &peers)
{
    m_peers = peers;
    m_pinned.reset();
    for (const channel::Peer &peer : peers) {
        for (const std::uint8_t systemId : peer.systemIds)
            m_pinned.set(systemId);
    }
    for (auto &[session, speaker] : m_speakers)
        applyRules(speaker);
    collectSealed();
}

void SenderPolicy::applyRules(Speaker &speaker) const
{
    speaker.bound.reset();
    speaker.allowed.reset();
    speaker.pilot = false;
    for (const channel::Peer &known : m_peers) {
        if (known.key != speaker.peer)
            continue;
        speaker.pilot = known.role == channel::PeerRole::Pilot;
        for (const std::uint8_t systemId : known.systemIds)
            speaker.bound.set(systemId);
        speaker.allowed = known.systemIds.empty() ? ~m_pinned : speaker.bound;
    }
    speaker.spoken &= speaker.allowed;
}

void SenderPolicy::rememberSealed(const SealedSystems &heard)
{
    for (const auto &[peer, systems] : heard) {
        m_heard[peer] |= systems;
        m_claims.try_emplace(peer);
    }
    collectSealed();
}

void SenderPolicy::collectSealed()
{
    // The vehicle of a peer that was removed from the list may be accepted in clear again.
    const auto isGone = [this](const channel::PublicKey &key) {
        return std::none_of(m_peers.begin(), m_peers.end(), [&](const channel::Peer &peer) { return peer.key == key; });
    };
    std::erase_if(m_heard, [&](const auto &entry) { return isGone(entry.first); });
    std::erase_if(m_claims, [&](const auto &entry) { return isGone(entry.first); });
    std::erase_if(m_sealedPlaces, [&](const SealedPlace &place) { return isGone(place.peer); });
    m_sealed.reset();
    for (const auto &[peer, systems] : m_heard)
        m_sealed |= systems;
}

void SenderPolicy::sessionUp(channel::SessionId session, const channel::PublicKey &peer, const Path &path)
{
    Speaker speaker;
    speaker.peer = peer;
    speaker.path = path;
    applyRules(speaker);
    m_speakers[session] = speaker;
    m_claims[peer].reset();
    noteSealedAt(peer, path);
}

void SenderPolicy::sessionMoved(channel::SessionId session, const Path &path)
{
    const auto found = m_speakers.find(session);
    if (found == m_speakers.end())
        return;
    found->second.path = path;
    noteSealedAt(found->second.peer, path);
}

void SenderPolicy::noteSealedAt(const channel::PublicKey &peer, const Path &path)
{
    std::erase_if(m_sealedPlaces, [&](const SealedPlace &place) { return place.path.sharesPlace(path); });
    m_sealedPlaces.push_back({peer, path});
    if (m_sealedPlaces.size() > kMostPlaces)
        m_sealedPlaces.pop_front();
}

bool SenderPolicy::sealedSpokeAt(const Path &path) const
{
    return std::any_of(m_sealedPlaces.begin(), m_sealedPlaces.end(),
                       [&](const SealedPlace &place) { return place.path.sharesPlace(path); });
}

void SenderPolicy::sessionDown(channel::SessionId session)
{
    m_speakers.erase(session);
}

bool SenderPolicy::mayCommand(channel::SessionId session) const
{
    const auto found = m_speakers.find(session);
    return found != m_speakers.end() && found->second.pilot;
}

bool SenderPolicy::pilotThere() const
{
    return std::any_of(m_speakers.begin(), m_speakers.end(), [](const auto &entry) { return entry.second.pilot; });
}

bool SenderPolicy::isPilotsSystem(std::uint8_t systemId) const
{
    const auto uses = [&](const channel::Peer &peer) {
        const auto heard = m_heard.find(peer.key);
        return std::ranges::find(peer.systemIds, systemId) != peer.systemIds.end()
            || (heard != m_heard.end() && heard->second.test(systemId));
    };
    return std::ranges::any_of(m_peers,
                               [&](const channel::Peer &peer) { return peer.role == channel::PeerRole::Pilot && uses(peer); });
}

bool SenderPolicy::acceptSealed(channel::SessionId session, std::uint8_t systemId)
{
    const auto found = m_speakers.find(session);
    if (found == m_speakers.end())
        return false;
    Speaker &speaker = found->second;
    if (speaker.spoken.test(systemId))
        return true;
    if (!speaker.allowed.test(systemId))
        return false;
    const auto own = m_heard.find(speaker.peer);
    const bool known = speaker.bound.test(systemId) || (own != m_heard.end() && own->second.test(systemId));
    if (m_rule == Speakers::OnePerSystem && !known && (holderOf(systemId, speaker.peer) || hasAllItsSystems(speaker)))
        return false;
    for (const auto &[other, holder] : m_speakers) {
        if (m_rule == Speakers::OnePerSystem && holder.spoken.test(systemId) && holder.peer != speaker.peer)
            return false;
    }
    speaker.spoken.set(systemId);
    m_heard[speaker.peer].set(systemId);
    m_sealed.set(systemId);
    return true;
}

bool SenderPolicy::hasAllItsSystems(const Speaker &speaker) const
{
    const auto heard = m_heard.find(speaker.peer);
    return speaker.bound.none() && heard != m_heard.end() && heard->second.count() >= kMostUnbound;
}

void SenderPolicy::endClaims(TimePoint now)
{
    for (auto claim = m_claims.begin(); claim != m_claims.end();) {
        auto &[peer, end] = *claim;
        const bool hasSession = std::any_of(m_speakers.begin(), m_speakers.end(),
                                            [&key = peer](const auto &entry) { return entry.second.peer == key; });
        if (hasSession)
            end.reset();
        else if (!end)
            end = now + kClaimOutlivesSession;
        const bool isOver = end && now >= *end;
        claim = isOver ? m_claims.erase(claim) : std::next(claim);
    }
}

/// The peer to which the list binds the system, or one that used it and still may.
const channel::Peer *SenderPolicy::holderOf(std::uint8_t systemId, const channel::PublicKey &except) const
{
    const auto holds = [&](const channel::Peer &peer) {
        if (!peer.systemIds.empty())
            return std::find(peer.systemIds.begin(), peer.systemIds.end(), systemId) != peer.systemIds.end();
        const auto heard = m_heard.find(peer.key);
        return heard != m_heard.end() && heard->second.test(systemId) && m_claims.contains(peer.key);
    };
    const auto found = std::find_if(m_peers.begin(), m_peers.end(),
                                    [&](const channel::Peer &peer) { return peer.key != except && holds(peer); });
    return found == m_peers.end() ? nullptr : &*found;
}

bool SenderPolicy::belongsToAnother(std::uint8_t systemId, channel::SessionId asker) const
{
    const auto found = m_speakers.find(asker);
    return found == m_speakers.end() || holderOf(systemId, found->second.peer);
}

std::string SenderPolicy::ownerOf(std::uint8_t systemId, channel::SessionId asker) const
{
    const auto found = m_speakers.find(asker);
    const channel::Peer *holder = holderOf(systemId, found == m_speakers.end() ? channel::PublicKey{} : found->second.peer);
    return holder ? holder->name : std::string();
}

bool SenderPolicy::acceptClear(const Path &from, std::uint8_t systemId) const
{
    if (m_mode == SecureMode::Off)
        return true;
    return mayBeClear(from, systemId) && !needsApproval(from, systemId);
}

bool SenderPolicy::mayBeClear(const Path &from, std::uint8_t systemId) const
{
    return m_mode != SecureMode::Required && !isSealedSystem(systemId) && !sessionAt(from);
}

bool SenderPolicy::needsApproval(const Path &from, std::uint8_t systemId) const
{
    return m_mode == SecureMode::Preferred && !m_allowed.test(systemId) && mayBeClear(from, systemId)
        && std::any_of(m_peers.begin(), m_peers.end(), [this](const channel::Peer &peer) { return mayHaveAnySystem(peer); });
}

bool SenderPolicy::mayHaveAnySystem(const channel::Peer &peer) const
{
    const auto heard = m_heard.find(peer.key);
    return peer.systemIds.empty() && (heard == m_heard.end() || heard->second.none());
}

std::string SenderPolicy::neverHeard() const
{
    std::string out;
    for (const channel::Peer &peer : m_peers) {
        if (mayHaveAnySystem(peer))
            out += (out.empty() ? "" : ", ") + peer.name;
    }
    return out;
}

std::optional<channel::SessionId> SenderPolicy::sessionAt(const Path &path) const
{
    for (const auto &[session, speaker] : m_speakers) {
        if (speaker.path.sharesPlace(path))
            return session;
    }
    return std::nullopt;
}

std::optional<channel::SessionId> SenderPolicy::sessionConcerned(const Path &from, std::uint8_t systemId) const
{
    if (const auto here = sessionAt(from))
        return here;
    for (const auto &[session, speaker] : m_speakers) {
        if (speaker.spoken.test(systemId))
            return session;
    }
    return std::nullopt;
}

} // namespace skyseal::engine
