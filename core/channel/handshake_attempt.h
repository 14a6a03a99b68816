// A station's attempt to get a session with one peer on one carrier: the addresses where the peer may be, and the first
// message that is being sent to them (PROTOCOL.md, sections 3, 4 and 4.1).
#pragma once

#include "core/channel/cookie.h"
#include "core/channel/handshake.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace skyseal::channel {

struct HandshakeAttempt
{
    /// An address where the peer may be, and the latest cookie that came from there.
    struct Place
    {
        Path path;
        std::optional<Cookie> cookie;
        TimePoint cookieUntil{};
        bool underCookie =
            false;              ///< the next copy goes under the cookie; copies alternate, since a cookie may be old or forged
        bool proven = false;    ///< the peer had a session there, or received a first message there
        bool answerDue = false; ///< announced and not answered yet; one copy may go to an unproven address
        TimePoint lastSent = TimePoint::min();
        TimePoint pausedUntil = TimePoint::min(); ///< for copies by timer, after an announcement was answered at once
    };

    /// The first message in use. Copies of it get the same answer, which may take long to arrive.
    struct First
    {
        Initiator handshake;
        std::shared_ptr<const Key32> presharedKey;
        TimePoint begun{};
        unsigned copies = 0;
        unsigned uncookied = 0; ///< copies with mac1 without a cookie in reply
        unsigned wrong = 0;     ///< wrong answers that cost a computation
    };

    /// Several, since anyone who knows the peer's key can announce it; one more than addresses that the operator names at a
    /// time, so that announcements displace none of these.
    static constexpr std::size_t kMaxPlaces = 5;

    /// Returns the place with this address. Makes one if there is none, in place of an unproven one if there are too many.
    Place &placeAt(const Path &path);
    /// Removes these places, except where the peer announced itself and waits for an answer.
    void stopCallingAt(std::span<const Path> paths);

    PublicKey peer{};
    Carrier carrier{}; ///< of all places
    std::vector<Place> places;
    std::optional<First> first;
    TimePoint due{};
    TimePoint wantedUntil{};
    unsigned sent = 0;                      ///< rounds of copies by timer, for the pause between two
    bool flooded = false;                   ///< wrong answers made us give up a first message
    TimePoint freshFrom = TimePoint::min(); ///< earliest time for the next first message
    unsigned unanswered = 0;                ///< copies since the last cookie
    TimePoint unansweredSince{};
    std::optional<TimePoint> announced; ///< latest announcement; none if a silent session is the only reason
    Path announcedFrom;
};

} // namespace skyseal::channel
