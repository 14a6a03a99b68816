// The agent's part of a pairing handshake: it calls while its window is open, and answers stations that received a call.
#pragma once

#include "core/channel/token_bucket.h"
#include "core/channel/handshake_limit.h"
#include "core/channel/pairing_confirmation.h"

namespace skyseal::channel {

class PairingAgent
{
public:
    PairingAgent(PairingCore &core, TimePoint now);

    void handleFirst(TimePoint now, const Path &from, ByteView datagram);
    /// Finishes a handshake: the writer has the key, and knows the passphrase if there is one.
    std::optional<PairingConfirmation> handleThird(TimePoint now, const Path &from, ByteView datagram);
    void call(TimePoint now);
    TimePoint callDue() const { return m_callDue; }

private:
    /// An answered first message. Only a few are kept; a new one replaces the oldest.
    struct Answered
    {
        PairingHandshake handshake;
        Path path;
        PairingDatagram first{};
        PairingDatagram answer{};
        TimePoint at{};
        TokenBucket thirds; ///< third messages that may be computed on
    };
    void forgetOldAnswers(TimePoint now);
    bool mayCompute(TimePoint now, const Path &from);

    PairingCore &m_core;
    PairingToken m_token{};
    HandshakeLimit m_limit;
    std::vector<Answered> m_answered;
    TimePoint m_callDue;
};

} // namespace skyseal::channel
