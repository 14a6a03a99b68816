// The agent's handshakes: it announces itself to stations that have no session with it, and answers first messages
// (PROTOCOL.md, sections 3 and 4).
#pragma once

#include "core/channel/cookie.h"
#include "core/channel/endpoint_core.h"
#include "core/channel/handshake_limit.h"
#include "core/channel/interval_limit.h"

namespace skyseal::channel {

class AgentHandshakes
{
public:
    AgentHandshakes(EndpointCore &core, TimePoint now);

    TimePoint deadline(TimePoint now);

    /// Precondition: the datagram has kFirstLength bytes. Returns false if nothing has changed: the message was refused, or
    /// answered as before.
    bool handleFirst(TimePoint now, const Path &from, ByteView datagram);
    /// The first authentic record arrived in an answered session, so its first message was not replayed. Returns false, and
    /// discards the session, if the station's counter could not be stored.
    bool confirm(TimePoint now, SessionTable::Entry &entry);
    void peersChanged();
    void handleDeadline(TimePoint now);

private:
    /// An answered first message whose session the station has not confirmed yet.
    struct Answered
    {
        PublicKey peer{};
        std::uint64_t counter = 0;
        SessionId session{};
        TimePoint until{};
        FirstMessage first{};
        AnswerMessage answer{};
    };
    /// Addresses of the announcements: on links with an active session, and on the others.
    struct Targets
    {
        std::vector<Path> beside, alone;
    };
    /// Announcements to one kind of targets.
    struct Rounds
    {
        TimePoint latest;
        std::size_t turn = 0; ///< where the next one begins
        TimePoint due(const std::vector<Path> &targets, Duration every) const
        {
            return targets.empty() ? kNever : latest + every;
        }
    };

    bool refuse(TimePoint now, const Path &from, RefusalReason reason, const PublicKey &peer = {});
    void sendNumber(TimePoint now, const Path &from, const Peer &peer, Responder &&responder);
    bool mayCompute(TimePoint now, const Path &from, ByteView datagram, bool proven);
    bool expects(const Path &from);
    void makeRoomFor(const PublicKey &peer);
    const Answered *greatestOf(const PublicKey &peer) const;
    template<typename Condition> void discardIf(Condition condition);
    Targets announceTargets(TimePoint now);
    void announce(TimePoint now, Rounds &rounds, const std::vector<Path> &targets, Duration every);
    void requestReports(TimePoint now);
    TimePoint announceDue(const Targets &targets) const;

    EndpointCore &m_core;
    Announcement m_announcement;
    std::vector<Answered> m_answered; ///< oldest first
    Rounds m_beside, m_alone;
    IntervalLimit m_requests; ///< of reports, for quiet sessions
    std::size_t m_requestTurn = 0;
    HandshakeLimit m_limit;
    CookieMaker m_cookies;
    IntervalLimit m_floodEvents;
    IntervalLimit m_numbers;
};

} // namespace skyseal::channel
