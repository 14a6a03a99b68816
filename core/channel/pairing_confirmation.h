// The part of a pairing after its handshake, the same at both ends: the decision of each person, in sealed messages ("words")
// that are repeated until the other end has acknowledged them.
#pragma once

#include "core/channel/pairing_core.h"

namespace skyseal::channel {

class PairingConfirmation
{
public:
    PairingConfirmation(PairingPeer peer, WordCipher words, TimePoint now);

    const PairingPeer &peer() const { return m_peer; }
    /// The other end has proved by a word that it holds its private key.
    bool isShown() const { return m_isShown; }
    Decision mine() const { return m_mine; }
    Decision theirs() const { return m_theirs; }
    bool paired() const { return m_mine == Decision::Yes && m_theirs == Decision::Yes; }
    /// The other end knows that both have confirmed, or has been silent for long.
    bool settled(TimePoint now) const;
    bool silent(TimePoint now) const;

    void decide(TimePoint now, Decision decision);
    /// Returns false if it is not a word of this pairing. A new decision changes theirs().
    bool receive(TimePoint now, const Path &from, ByteView datagram);
    void handleDeadline(TimePoint now, PairingCore &core);
    TimePoint deadline() const;
    WordDatagram word();

    /// Result if both have confirmed. The owner decides the role.
    Peer pairedPeer() const;

private:
    bool heardByPeer() const
    {
        return m_heardByPeer == Heard::AllIsSaid || static_cast<int>(m_heardByPeer) == static_cast<int>(m_mine);
    }

    PairingPeer m_peer;
    WordCipher m_words;
    bool m_isShown = false;
    Decision m_mine = Decision::None;
    Decision m_theirs = Decision::None;
    Heard m_heardByPeer = Heard::Nothing;
    TimePoint m_lastHeard;
    TimePoint m_due;
    TimePoint m_pairedAt = kNever;
    TimePoint m_heardAt = kNever; ///< first acknowledgement by the peer after both have confirmed
};

} // namespace skyseal::channel
