// The part of a pairing after its handshake, the same at both ends: what each person decided, said by words that are
// repeated until the other end has heard them.
#pragma once

#include "core/base/weakness.h"
#include "core/channel/pairing_core.h"

namespace skyseal::channel {

class PairingConfirmation
{
public:
    PairingConfirmation(PairingPeer peer, PairingVoice voice, bool presharedKeyWanted, TimePoint now);

    const PairingPeer &peer() const { return m_peer; }
    bool isOf(const Path &from, PairingId id) const { return from == m_peer.path && id == m_voice.id(); }
    Decision mine() const { return m_mine; }
    Decision theirs() const { return m_theirs; }
    bool paired() const { return (m_mine == Decision::Yes || weakened(Weakness::PairOnOneYes)) && m_theirs == Decision::Yes; }
    /// The other end knows that both said yes, or nothing was heard of it for long after.
    bool settled(TimePoint now) const;
    bool silent(TimePoint now) const;

    void decide(TimePoint now, Decision decision);
    /// False when it is no word of this talk. Something new makes `theirs()` change.
    bool hear(TimePoint now, const Path &from, ByteView datagram);
    /// The other end repeats itself: it has not heard us.
    void repeat(TimePoint now) { m_due = std::min(m_due, now); }
    void handleDeadline(TimePoint now, PairingCore &core);
    TimePoint deadline() const;
    WordDatagram word();

    /// To be kept when both said yes.
    Peer pairedPeer() const;

private:
    bool heardByPeer() const
    {
        return m_heardByPeer == Heard::AllIsSaid || static_cast<int>(m_heardByPeer) == static_cast<int>(m_mine);
    }

    PairingPeer m_peer;
    PairingVoice m_voice;
    bool m_presharedKeyWanted;
    Decision m_mine = Decision::None;
    Decision m_theirs = Decision::None;
    Heard m_heardByPeer = Heard::Nothing;
    TimePoint m_lastHeard;
    TimePoint m_due;
    TimePoint m_pairedAt = kNever;
    TimePoint m_heardAt = kNever; ///< when the peer, after both said yes, first said that it heard ours
};

} // namespace skyseal::channel
