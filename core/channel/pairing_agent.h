// The agent's part of a pairing handshake (PROTOCOL.md, section 13): it sends calls while its window is open, and answers
// stations that received a call. An opening of a station is a guess of the passphrase. Therefore a guess leaves no trace except
// its counted outcome, and after the first correct opening no other one is tested.
#pragma once

#include "core/channel/handshake_limit.h"
#include "core/channel/pairing_confirmation.h"

#include <vector>

namespace skyseal::channel {

class PairingAgent
{
public:
    PairingAgent(PairingCore &core, TimePoint now);

    /// Request of a station to an agent that listens: answered by a call, until an opening was correct.
    void handleRequest(const Path &from);
    /// Answered until the opening of a station was correct; afterwards only reported, whether or not its sender knows the
    /// passphrase.
    void handleFirst(TimePoint now, const Path &from, ByteView datagram);
    /// The station's opening. The first correct one of a window is answered by our own, as are its copies; others are ignored.
    std::optional<PairingConfirmation> handleOpening(TimePoint now, const Path &from, ByteView datagram);
    void call(TimePoint now);
    TimePoint callDue() const { return m_core.config.callTo.empty() ? kNever : m_callDue; }

private:
    /// An answered first message. Only a few are kept; a new one replaces the oldest.
    struct Answered
    {
        PairingHandshake handshake;
        Path path;
        TimePoint at{};
        bool failed = false; ///< an opening was wrong; counts once, since one share tests one passphrase
    };
    /// The handshake in which this end showed its opening.
    struct Opened
    {
        Path path;
        PairingDatagram first{}; ///< the station's
        OpeningDatagram theirs{};
        OpeningDatagram ours{};
    };
    void forgetOldAnswers(TimePoint now);
    bool hasOpened() const;
    bool mayCompute(TimePoint now, const Path &from);
    void noteWrongOpening(TimePoint now, Answered &answered);

    PairingCore &m_core;
    PairingToken m_token{};
    HandshakeLimit m_limit;
    std::vector<Answered> m_answered;
    std::optional<Opened> m_opened;
    unsigned m_wrongPassphrases = 0;
    TimePoint m_callDue;
};

} // namespace skyseal::channel
