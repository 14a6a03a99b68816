// The station's part of a pairing handshake: it waits for calls and tries one caller after the other, until one answers.
#pragma once

#include "core/channel/pairing_confirmation.h"

#include <vector>

namespace skyseal::channel {

class PairingStation
{
public:
    explicit PairingStation(PairingCore &core) : m_core(core) {}

    /// Requests calls of agents that listen.
    void request(TimePoint now);
    TimePoint requestDue() const { return isRequesting() ? m_requestDue : kNever; }
    void handleCall(TimePoint now, const Path &from, ByteView datagram);
    /// The first answer of a window is answered by our opening.
    void handleAnswer(TimePoint now, const Path &from, ByteView datagram);
    /// The agent's opening.
    std::optional<PairingConfirmation> handleOpening(TimePoint now, const Path &from, ByteView datagram);
    void handleDeadline(TimePoint now);
    TimePoint deadline() const;

private:
    struct Caller
    {
        Path path;
        PairingToken token{};
        TimePoint heard{};
        TimePoint tried = TimePoint::min();
    };
    /// A handshake with one caller; after its answer the opening is repeated until the agent's comes.
    struct Attempt
    {
        PairingHandshake handshake;
        Path path;
        TimePoint until{};
        TimePoint sentAt{};
        bool opened = false;
        TimePoint openingDue = kNever;
        unsigned openingsSent = 0;
    };

    bool isRequesting() const { return !m_core.config.callTo.empty() && !(m_attempt && m_attempt->opened); }
    void begin(TimePoint now);
    void sendOpening(TimePoint now);
    void giveUp();

    PairingCore &m_core;
    std::vector<Caller> m_callers;
    std::optional<Attempt> m_attempt;
    TimePoint m_nextFrom = TimePoint::min(); ///< earliest time of the next attempt
    TimePoint m_requestDue = TimePoint::min();
};

} // namespace skyseal::channel
