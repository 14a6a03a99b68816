#include "core/channel/pairing_confirmation.h"

namespace skyseal::channel {

namespace {

constexpr Duration kRepeat = std::chrono::milliseconds(250); ///< until the other end has acknowledged the last word
constexpr Duration kKeepAlive = std::chrono::seconds(1);
constexpr Duration kSilence = std::chrono::seconds(10);
constexpr Duration kLinger = std::chrono::seconds(3);      ///< after the other end is known to be done
constexpr Duration kLongLinger = std::chrono::seconds(10); ///< when it is not

} // namespace

PairingConfirmation::PairingConfirmation(PairingPeer peer, WordCipher words, TimePoint now)
    : m_peer(std::move(peer)), m_words(std::move(words)), m_lastHeard(now), m_due(now)
{}

bool PairingConfirmation::settled(TimePoint now) const
{
    if (!paired())
        return false;
    return now >= m_pairedAt + kLongLinger || (m_heardAt != kNever && now >= m_heardAt + kLinger);
}

bool PairingConfirmation::silent(TimePoint now) const
{
    return !paired() && now >= m_lastHeard + kSilence;
}

void PairingConfirmation::decide(TimePoint now, Decision decision)
{
    m_mine = decision;
    m_due = now;
    if (paired())
        m_pairedAt = now;
}

bool PairingConfirmation::receive(TimePoint now, const Path &from, ByteView datagram)
{
    const auto word = from == m_peer.path ? m_words.open(datagram) : std::nullopt;
    if (!word)
        return false;
    m_lastHeard = now;
    m_isShown = true;
    // Old words may arrive late or be replayed: a decision is final.
    m_heardByPeer = std::max(m_heardByPeer, word->heard);
    if (word->mine > m_theirs && !paired()) {
        m_theirs = word->mine;
        m_due = now;
        if (paired())
            m_pairedAt = now;
    }
    if (paired() && heardByPeer() && m_heardAt == kNever)
        m_heardAt = now;
    if (paired() && word->heard != Heard::AllIsSaid)
        m_due = now; // The peer has not received our acknowledgement yet.
    return true;
}

WordDatagram PairingConfirmation::word()
{
    const bool allIsSaid = paired() && heardByPeer();
    return m_words.seal({m_mine, allIsSaid ? Heard::AllIsSaid : static_cast<Heard>(m_theirs)});
}

void PairingConfirmation::handleDeadline(TimePoint now, PairingCore &core)
{
    if (now < m_due || silent(now) || settled(now))
        return;
    core.outgoing.push(m_peer.path, word());
    const bool heard = heardByPeer();
    if (paired() && heard)
        m_due = kNever; // From now on only in answer to a word.
    else
        m_due = now + core.jittered(heard ? kKeepAlive : kRepeat);
}

TimePoint PairingConfirmation::deadline() const
{
    if (!paired())
        return std::min(m_due, m_lastHeard + kSilence);
    return std::min({m_due, m_pairedAt + kLongLinger, m_heardAt == kNever ? kNever : m_heardAt + kLinger});
}

Peer PairingConfirmation::pairedPeer() const
{
    Peer peer{m_peer.key, m_peer.name, PeerRole::Observer, {}, m_words.presharedKey()};
    if (m_peer.systemId != 0)
        peer.systemIds = {m_peer.systemId};
    return peer;
}

} // namespace skyseal::channel
