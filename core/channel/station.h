// The station's side of getting sessions: it hears announcements, or that a session fell silent, and shakes hands.
#pragma once

#include "core/channel/endpoint_core.h"

namespace skyseal::channel {

class Station
{
public:
    explicit Station(EndpointCore &core);

    void peersChanged();
    void handleAnnouncement(TimePoint now, const Path &from, ByteView datagram);
    void handleAnswer(TimePoint now, const Path &from, ByteView datagram);
    /// An authentic record of a session came: its peer is there and still has it, so no other is needed.
    void sessionLives(const PublicKey &peer);
    bool idle() const { return m_attempts.empty(); }
    void handleDeadline(TimePoint now);
    TimePoint deadline(TimePoint now);

private:
    struct Known
    {
        PublicKey key{};
        Announcement announcement;
    };
    /// The wish for a session with one peer, from the first sign of it until it is up or the peer is gone.
    struct Attempt
    {
        PublicKey peer{};
        std::vector<Path> paths; ///< where the peer may be; several, since anyone who knows its key can announce it
        TimePoint due{};
        TimePoint wantedUntil{};
        TimePoint lastSent{};
        unsigned sent = 0;         ///< in all, for the pause between two
        unsigned sentThisOne = 0;  ///< copies of the present first message
        std::optional<Initiator> handshake;
    };

    Attempt *attemptWith(const PublicKey &peer);
    Attempt &want(TimePoint now, const PublicKey &peer, TimePoint due);
    void send(TimePoint now, Attempt &attempt);
    bool renew(Attempt &attempt);
    void drop(Attempt &attempt);
    void dropUnwanted(TimePoint now);
    Duration pauseAfter(unsigned sent) const;

    EndpointCore &m_core;
    std::vector<Known> m_known;
    std::vector<Attempt> m_attempts;
};

} // namespace skyseal::channel
