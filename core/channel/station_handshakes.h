// The station's handshakes: it answers announcements of known agents, calls agents that listen, and replaces sessions that fell
// silent (PROTOCOL.md, section 4).
#pragma once

#include "core/channel/agent_calls.h"
#include "core/channel/endpoint_core.h"
#include "core/channel/handshake_attempt.h"
#include "core/channel/known_agents.h"
#include "core/channel/token_bucket.h"

namespace skyseal::channel {

class StationHandshakes
{
public:
    explicit StationHandshakes(EndpointCore &core);

    // query
    bool idle() const { return m_attempts.empty(); }
    std::vector<Unanswered> unanswered() const;
    TimePoint deadline(TimePoint now);
    std::optional<TimePoint> lastCall(const Path &place) const { return m_calls.lastCall(place); }

    // input
    void peersChanged();
    /// Discards the first messages that carry the former offer.
    void policyChanged();
    /// Returns false if nothing has changed: the announcement was refused, and may be one of a flood.
    bool handleAnnouncement(TimePoint now, const Path &from, ByteView datagram);
    /// Returns false as above.
    bool handleAnswer(TimePoint now, const Path &from, ByteView datagram);
    /// The agent remembers a greater counter than ours. Returns false as above.
    bool handleNumber(TimePoint now, const Path &from, ByteView datagram);
    void handleCookie(TimePoint now, const Path &from, ByteView datagram);
    /// An authentic record arrived in this session, so its peer needs no new one.
    void sessionLives(const Session &session);
    void handleDeadline(TimePoint now);
    /// Replaces the addresses of agents that listen. Calls at removed addresses end at once; new ones are
    /// called from the next turn on.
    void setCallAt(std::vector<Path> paths);

private:
    using Attempt = HandshakeAttempt;
    using Place = HandshakeAttempt::Place;

    void callAgents(TimePoint now);
    bool isTaken(TimePoint now, const Path &place);
    static bool mayReplace(const Session &session, Carrier carrier);
    Attempt *attemptWith(const PublicKey &peer, Carrier carrier);
    Attempt *attemptOfCookie(TimePoint now, const Path &from, ByteView datagram, Cookie &cookie);
    Attempt *attemptAnsweredBy(const Path &from, ByteView datagram);
    bool isRepeated(ByteView datagram) const;
    Attempt &want(TimePoint until, const PublicKey &peer, Carrier carrier, TimePoint due);
    void send(TimePoint now, Attempt &attempt);
    void sendTo(TimePoint now, Attempt &attempt, Place &place);
    bool prepareFirst(TimePoint now, Attempt &attempt);
    bool makeFirst(TimePoint now, Attempt &attempt);
    void discardFirst(Attempt &attempt);
    void giveUpFirst(TimePoint now, Attempt &attempt);
    bool mayCompute(TimePoint now, Attempt &attempt);
    bool countWrongAnswer(TimePoint now, Attempt &attempt);
    void drop(Attempt &attempt);
    void dropUnwanted(TimePoint now);
    Duration pauseAfter(unsigned sent) const;

    EndpointCore &m_core;
    KnownAgents m_known;
    std::vector<Attempt> m_attempts;
    AgentCalls m_calls;
    TokenBucket m_answers; ///< answers that may be computed on
};

} // namespace skyseal::channel
