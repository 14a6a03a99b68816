// The agent's side of coming to talk: it calls while its window is open, and answers who has heard it.
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
    /// A handshake that is over: whoever wrote it owns the key, and knows the passphrase if there is one.
    std::optional<PairingConfirmation> handleThird(TimePoint now, const Path &from, ByteView datagram);
    void call(TimePoint now);
    TimePoint callDue() const { return m_callDue; }

private:
    /// A first message that was answered. Only a few are remembered; a newer one takes the place of the oldest.
    struct Answered
    {
        PairingHandshake handshake;
        Path path;
        PairingDatagram first{};
        PairingDatagram answer{};
        TimePoint at{};
        TokenBucket thirds; ///< that may still be computed on
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
