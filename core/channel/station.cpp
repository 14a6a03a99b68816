#include "core/channel/station.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kMaxPlaces = 4;
/// The same first message goes out so often before a fresh one is made: copies are answered idempotently, and a fresh one
/// is needed when the agent took one and then restarted.
constexpr unsigned kCopies = 4;
constexpr Duration kLongestPause = std::chrono::seconds(2);
/// An agent that was announced and is not heard again is gone.
constexpr Duration kWantedFor = std::chrono::seconds(10);
constexpr Duration kAnnouncementPause = std::chrono::milliseconds(50);

} // namespace

Station::Station(EndpointCore &core) : m_core(core)
{
    peersChanged();
}

void Station::peersChanged()
{
    m_known.clear();
    for (const Peer &peer : m_core.config.peers)
        m_known.push_back({peer.key, Announcement(peer.key)});
    for (Attempt &attempt : m_attempts) {
        if (!m_core.peer(attempt.peer))
            attempt.wantedUntil = TimePoint::min();
    }
    dropUnwanted(TimePoint::min());
}

Station::Attempt *Station::attemptWith(const PublicKey &peer)
{
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(), [&](const Attempt &a) { return a.peer == peer; });
    return found == m_attempts.end() ? nullptr : &*found;
}

Station::Attempt &Station::want(TimePoint now, const PublicKey &peer, TimePoint due)
{
    Attempt *attempt = attemptWith(peer);
    if (!attempt) {
        attempt = &m_attempts.emplace_back();
        attempt->peer = peer;
        attempt->due = due;
        attempt->lastSent = TimePoint::min();
    }
    attempt->wantedUntil = now + kWantedFor;
    return *attempt;
}

void Station::handleAnnouncement(TimePoint now, const Path &from, ByteView datagram)
{
    if (datagram.size() != Announcement::kLength) {
        ++m_core.strays.malformed;
        return;
    }
    const auto known = std::find_if(m_known.begin(), m_known.end(),
                                    [&](const Known &k) { return k.announcement.recognises(datagram); });
    if (known == m_known.end()) {
        ++m_core.strays.forged;
        m_core.tellRefused(now, from, RefusalReason::UnknownPeer);
        return;
    }
    // While a session lives, an announcement is a replay or the word of an agent that has just restarted: it counts once the
    // session has been quiet for longer than a living one ever is.
    TimePoint due = now;
    if (const Session *session = m_core.table.upWith(known->key);
        session && !session->closing() && !weakened(Weakness::TrustAnnouncements))
        due = std::max(now, session->lastReceived() + m_core.config.timing.keepAliveAfter * 5 / 4);
    Attempt &attempt = want(now, known->key, due);
    Place &place = placeAt(attempt, from);
    place.owed = std::min(place.owed + 1, kCopies);
    // It is there, so waiting longer is of no use; but never more than one answer to one announcement.
    if (due == now && now >= attempt.lastSent + kAnnouncementPause)
        attempt.due = now;
}

Station::Place &Station::placeAt(Attempt &attempt, const Path &path)
{
    auto &places = attempt.places;
    const auto found = std::find_if(places.begin(), places.end(), [&](const Place &place) { return place.path == path; });
    if (found != places.end())
        return *found;
    if (places.size() == kMaxPlaces)
        places.erase(places.begin());
    Place &place = places.emplace_back();
    place.path = path;
    return place;
}

void Station::handleCookie(TimePoint now, const Path &from, ByteView datagram)
{
    for (Attempt &attempt : m_attempts) {
        for (Place &place : attempt.places) {
            if (place.path != from || place.unanswered == 0 || !attempt.handshake)
                continue;
            const auto cookie = openCookie(attempt.peer, ByteView(attempt.handshake->message()).last(kMacLength), datagram);
            if (!cookie)
                continue;
            --place.unanswered;
            place.cookie = cookie;
            place.cookieUntil = now + kCookieSecretLife;
            place.underCookie = true;
            place.proven = true;
            sendTo(now, attempt, place);
            return;
        }
    }
    ++m_core.strays.forged;
}

void Station::handleAnswer(TimePoint now, const Path &from, ByteView datagram)
{
    const auto connection = answeredConnection(datagram);
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(), [&](const Attempt &a) {
        return a.handshake && connection && a.handshake->connection() == *connection;
    });
    if (found == m_attempts.end()) { // Also the second copy of an answer.
        ++m_core.strays.malformed;
        return;
    }
    auto agreement = found->handshake->takeAnswer(datagram);
    if (!agreement) {
        ++m_core.strays.forged;
        m_core.tellRefused(now, from, agreement.error(), found->peer);
        return;
    }
    const ConnectionId ours = found->handshake->connection();
    SessionSetup setup{m_core.table.number(ours), true, *m_core.peer(found->peer), ours, agreement->peerConnection,
                       std::move(agreement->peerOffer), agreement->suite, std::move(agreement->chain), from};
    m_attempts.erase(found); // Its slot goes on as the session's.
    auto &entry = m_core.table.put(std::make_unique<Session>(std::move(setup), m_core.around, now), false, now);
    m_core.bringUp(now, entry);
    entry.session->handleDeadline(now); // The first report proves to the agent that we are no replay.
}

void Station::sessionLives(const PublicKey &peer)
{
    if (Attempt *attempt = attemptWith(peer))
        drop(*attempt);
}

void Station::handleDeadline(TimePoint now)
{
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up || !entry.session->silent(now))
            return;
        Attempt &attempt = want(now, entry.session->peer().key, now);
        placeAt(attempt, entry.session->path()).proven = true;
    });
    dropUnwanted(now);
    for (Attempt &attempt : m_attempts) {
        if (now >= attempt.due)
            send(now, attempt);
    }
}

TimePoint Station::deadline(TimePoint now)
{
    TimePoint due = kNever;
    for (const Attempt &attempt : m_attempts)
        due = std::min({due, attempt.due, attempt.wantedUntil});
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up && !entry.session->silent(now))
            due = std::min(due, entry.session->silentFrom());
    });
    return due;
}

void Station::send(TimePoint now, Attempt &attempt)
{
    const auto maySend = [](const Place &place) { return place.proven || place.owed > 0; };
    if (std::none_of(attempt.places.begin(), attempt.places.end(), maySend)) {
        attempt.due = now + kLongestPause; // Until it is announced again.
        return;
    }
    if ((!attempt.handshake || attempt.sentThisOne >= kCopies) && !renew(attempt)) {
        attempt.due = now + kLongestPause;
        return;
    }
    for (Place &place : attempt.places) {
        if (maySend(place))
            sendTo(now, attempt, place);
    }
    ++attempt.sentThisOne;
    attempt.lastSent = now;
    attempt.due = now + pauseAfter(attempt.sent++);
}

void Station::sendTo(TimePoint now, const Attempt &attempt, Place &place)
{
    FirstMessage message = attempt.handshake->message();
    const bool hasCookie = place.cookie && now < place.cookieUntil;
    if (hasCookie && place.underCookie)
        signWithCookie(*place.cookie, message);
    else
        place.unanswered = std::min(place.unanswered + 1, kCopies);
    place.underCookie = hasCookie && !place.underCookie;
    place.owed -= place.owed > 0;
    m_core.around.outbox.send(place.path, message);
}

bool Station::renew(Attempt &attempt)
{
    const auto connection = attempt.handshake ? attempt.handshake->connection()
                                              : m_core.table.reserve(m_core.around.random);
    if (!connection)
        return false;
    const Peer *peer = m_core.peer(attempt.peer);
    if (!peer)
        return false;
    attempt.handshake = Initiator::begin(*m_core.config.identity, *peer,
                                         FirstPayload{*connection, m_core.around.offer, m_core.counters.next()},
                                         m_core.around.random);
    attempt.sentThisOne = 0;
    for (Place &place : attempt.places)
        place.unanswered = 0;
    if (!attempt.handshake)
        m_core.table.release(*connection);
    return attempt.handshake.has_value();
}

Duration Station::pauseAfter(unsigned sent) const
{
    const Duration pause = std::min(kLongestPause, m_core.config.timing.handshakeRetry * (1 << std::min(sent, 8u)));
    // Up to a quarter more or less, so that stations which lost their agents at once do not call in step.
    std::uint8_t dice = 0;
    m_core.around.random.fill({&dice, 1});
    return pause * (384 + dice) / 512;
}

void Station::drop(Attempt &attempt)
{
    if (attempt.handshake)
        m_core.table.release(attempt.handshake->connection());
    m_attempts.erase(m_attempts.begin() + (&attempt - m_attempts.data()));
}

void Station::dropUnwanted(TimePoint now)
{
    for (std::size_t i = m_attempts.size(); i-- > 0;) {
        if (now >= m_attempts[i].wantedUntil)
            drop(m_attempts[i]);
    }
}

} // namespace skyseal::channel
