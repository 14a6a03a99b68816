// The station's side of getting sessions: it hears announcements, or that a session fell silent, and shakes hands.
#pragma once

#include "core/channel/token_bucket.h"
#include "core/channel/cookie.h"
#include "core/channel/endpoint_core.h"

namespace skyseal::channel {

class StationHandshakes
{
public:
    explicit StationHandshakes(EndpointCore &core);

    void peersChanged();
    /// Answers to first messages that carry the old offer are not taken any more: the next copies are new ones.
    void policyChanged();
    void handleAnnouncement(TimePoint now, const Path &from, ByteView datagram);
    /// False when it changed nothing: refused, perhaps one of a flood.
    bool handleAnswer(TimePoint now, const Path &from, ByteView datagram);
    /// An agent remembers a greater counter than ours. False as above.
    bool handleNumber(TimePoint now, const Path &from, ByteView datagram);
    void handleCookie(TimePoint now, const Path &from, ByteView datagram);
    /// An authentic record of a session came: its peer is there and still has it, so no other is needed.
    void sessionLives(const PublicKey &peer);
    bool idle() const { return m_attempts.empty(); }
    std::vector<Unanswered> unanswered() const;
    void handleDeadline(TimePoint now);
    TimePoint deadline(TimePoint now);

private:
    struct Known
    {
        PublicKey key{};
        Announcement announcement;
    };
    /// Where a peer may be, and the cookie that it last gave us there.
    struct Place
    {
        Path path;
        std::optional<Cookie> cookie;
        TimePoint cookieUntil{};
        bool underCookie = false; ///< so the next copy goes; copies take turns, since a cookie may be old or forged
        bool proven = false;      ///< the peer was there, or what we sent there was received
        bool owed = false;        ///< announced, and not answered yet; no more than that goes to an address unproven
        TimePoint lastSent = TimePoint::min();
        TimePoint pausedUntil = TimePoint::min(); ///< for copies by timer: an announcement from there was just answered
    };
    /// The wish for a session with one peer in one carrier, from the first sign of it until it is up or the peer is gone.
    struct Attempt
    {
        PublicKey peer{};
        Carrier carrier{};         ///< of all places
        std::vector<Place> places; ///< several, since anyone who knows its key can announce it
        TimePoint due{};
        TimePoint wantedUntil{};
        unsigned sent = 0;                      ///< in all, for the pause between two
        unsigned copies = 0;                    ///< of the present first message
        unsigned uncookied = 0;                 ///< of these without a cookie, and not answered by one
        TimePoint begun{};                      ///< when it was made
        unsigned wrong = 0;                     ///< answers to it that were computed on in vain
        bool flooded = false;                   ///< one was given up for these
        TimePoint freshFrom = TimePoint::min(); ///< not before then the next one is made in its place
        unsigned unanswered = 0;                ///< of all, since the last cookie
        TimePoint unansweredSince{};
        std::optional<TimePoint> announced; ///< none while it is only a session that fell silent
        Path announcedFrom;
        std::optional<Initiator> handshake;
        std::shared_ptr<const Key32> presharedKey; ///< that it is made with
    };

    Attempt *attemptWith(const PublicKey &peer, Carrier carrier);
    Attempt &want(TimePoint now, const PublicKey &peer, Carrier carrier, TimePoint due);
    static Place &placeAt(Attempt &attempt, const Path &path);
    void send(TimePoint now, Attempt &attempt);
    void sendTo(TimePoint now, Attempt &attempt, Place &place);
    bool ready(TimePoint now, Attempt &attempt);
    void forgetFirst(Attempt &attempt);
    bool renew(TimePoint now, Attempt &attempt);
    Attempt *attemptAnswered(const Path &from, ByteView datagram);
    bool mayCompute(TimePoint now, Attempt &attempt);
    bool countWrong(TimePoint now, Attempt &attempt);
    void giveUpFirst(TimePoint now, Attempt &attempt);
    void drop(Attempt &attempt);
    void dropUnwanted(TimePoint now);
    Duration pauseAfter(unsigned sent) const;

    EndpointCore &m_core;
    std::vector<Known> m_known;
    std::vector<Attempt> m_attempts;
    TokenBucket m_answers; ///< that may be computed on
};

} // namespace skyseal::channel
