// The agent's side of getting sessions: it announces itself where no station listens to it yet, and answers first messages.
#pragma once

#include "core/channel/cookie.h"
#include "core/channel/endpoint_core.h"
#include "core/channel/handshake_limit.h"

namespace skyseal::channel {

class AgentHandshakes
{
public:
    AgentHandshakes(EndpointCore &core, TimePoint now);

    /// A first message whose length is right. False when it changed nothing: refused, or answered as before.
    bool handleFirst(TimePoint now, const Path &from, ByteView datagram);
    /// The first authentic record of a session that was answered: the station is no replay. False when its counter could not
    /// be written down; the session is gone then.
    bool confirm(TimePoint now, SessionTable::Entry &entry);
    void peersChanged();
    void handleDeadline(TimePoint now);
    TimePoint deadline(TimePoint now);

private:
    /// An answered first message whose station has not shown yet that it took the answer.
    struct Answered
    {
        PublicKey peer{};
        std::uint64_t counter = 0;
        SessionId session{};
        TimePoint until{};
        FirstMessage first{};
        AnswerMessage answer{};
    };

    bool refuse(TimePoint now, const Path &from, RefusalReason reason, const PublicKey &peer = {});
    void tellNumber(TimePoint now, const Path &from, const Peer &peer, Responder &&responder);
    bool mayCompute(TimePoint now, const Path &from, ByteView datagram, bool proven);
    bool expects(const Path &from);
    void makeRoomFor(const PublicKey &peer);
    const Answered *furthestOf(const PublicKey &peer) const;
    template<typename Which> void forgetIf(Which which);
    /// Where to announce ourselves, and how often.
    struct Targets
    {
        std::vector<Path> paths;
        Duration every;
    };
    Targets announceTargets(TimePoint now);
    TimePoint announceDue(const Targets &targets) const;

    EndpointCore &m_core;
    Announcement m_announcement;
    std::vector<Answered> m_answered; ///< in the order in which they came
    TimePoint m_announced;            ///< last
    HandshakeLimit m_limit;
    CookieMaker m_cookies;
    TimePoint m_floodNotified;
    TimePoint m_numberNotified;
};

} // namespace skyseal::channel
