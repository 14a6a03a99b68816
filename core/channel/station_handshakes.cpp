#include "core/channel/station_handshakes.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kMaxPlaces = 4;
/// The same first message goes out so often, and for so long, before a fresh one is made. Copies are answered idempotently,
/// and an answer may take long; announcements that somebody repeats must not make us forget what it is an answer to.
constexpr unsigned kCopies = 4;
constexpr Duration kRenewAfter = std::chrono::seconds(5);
/// A peer that reports a greater counter is not believed: none may use up the counters that we have for all peers.
constexpr std::uint64_t kGreatestBelieved = kGreatestCounter / 2;
constexpr Duration kLongestPause = std::chrono::seconds(2);
/// An agent that was announced and is not heard again is gone.
constexpr Duration kWantedFor = std::chrono::seconds(10);
constexpr Duration kAnnouncementPause = std::chrono::milliseconds(50);
/// Each answer costs two Diffie-Hellmans before it is known to be false, and who hears the link can make such: the
/// connection id stands clear in an answer. So a first message with so many wrong ones is given up, and with it the number
/// that they were sent to, and no more are computed on than an agent does.
constexpr unsigned kWrongAnswers = 8;
constexpr double kAnswersPerSecond = 50;
constexpr double kAnswersAtOnce = 20;

} // namespace

StationHandshakes::StationHandshakes(EndpointCore &core) : m_core(core)
{
    peersChanged();
}

void StationHandshakes::peersChanged()
{
    m_known.clear();
    for (const Peer &peer : m_core.config.peers)
        m_known.push_back({peer.key, Announcement(peer.key)});
    for (Attempt &attempt : m_attempts) {
        const Peer *peer = m_core.peer(attempt.peer);
        if (!peer)
            attempt.wantedUntil = TimePoint::min();
        else if (!samePresharedKey(peer->presharedKey, attempt.presharedKey))
            forgetFirst(attempt);
    }
    dropUnwanted(TimePoint::min());
}

void StationHandshakes::policyChanged()
{
    for (Attempt &attempt : m_attempts)
        forgetFirst(attempt);
}

void StationHandshakes::forgetFirst(Attempt &attempt)
{
    if (attempt.handshake)
        m_core.table.release(attempt.handshake->connection());
    attempt.handshake.reset();
}

StationHandshakes::Attempt *StationHandshakes::attemptWith(const PublicKey &peer, Carrier carrier)
{
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(),
                                    [&](const Attempt &a) { return a.peer == peer && a.carrier == carrier; });
    return found == m_attempts.end() ? nullptr : &*found;
}

StationHandshakes::Attempt &StationHandshakes::want(TimePoint now, const PublicKey &peer, Carrier carrier, TimePoint due)
{
    Attempt *attempt = attemptWith(peer, carrier);
    if (!attempt) {
        attempt = &m_attempts.emplace_back();
        attempt->peer = peer;
        attempt->carrier = carrier;
        attempt->due = due;
    }
    attempt->wantedUntil = now + kWantedFor;
    return *attempt;
}

void StationHandshakes::handleAnnouncement(TimePoint now, const Path &from, ByteView datagram)
{
    if (datagram.size() != Announcement::kLength) {
        ++m_core.unmatched.malformed;
        return;
    }
    const auto known = std::find_if(m_known.begin(), m_known.end(),
                                    [&](const Known &k) { return k.announcement.recognises(datagram); });
    if (known == m_known.end()) {
        ++m_core.unmatched.forged;
        m_core.tellRefused(now, from, RefusalReason::UnknownPeer);
        return;
    }
    // While a session lives, an announcement is a replay or the word of an agent that has just restarted: it counts once the
    // session has been quiet for longer than a living one ever is.
    TimePoint due = now;
    if (const Session *session = m_core.table.upWith(known->key);
        session && !session->closing() && !weakened(Weakness::TrustAnnouncements))
        due = std::max(now, session->lastReceived() + m_core.config.timing.keepAliveAfter * 5 / 4);
    Attempt &attempt = want(now, known->key, from.carrier, due);
    attempt.announced = now;
    attempt.announcedFrom = from;
    Place &place = placeAt(attempt, from);
    place.owed = true;
    // It is there, so waiting is of no use; but never more than one answer to one announcement, and only to where it came
    // from: nobody can hurry or hold up what goes elsewhere.
    if (due == now && (place.lastSent == TimePoint::min() || now >= place.lastSent + kAnnouncementPause)
        && ready(now, attempt)) {
        sendTo(now, attempt, place);
        place.pausedUntil = now + m_core.config.timing.handshakeRetry;
    }
}

StationHandshakes::Place &StationHandshakes::placeAt(Attempt &attempt, const Path &path)
{
    auto &places = attempt.places;
    const auto found = std::find_if(places.begin(), places.end(), [&](const Place &place) { return place.path == path; });
    if (found != places.end())
        return *found;
    if (places.size() == kMaxPlaces) {
        const auto unproven = std::find_if(places.begin(), places.end(), [](const Place &place) { return !place.proven; });
        places.erase(unproven == places.end() ? places.begin() : unproven);
    }
    Place &place = places.emplace_back();
    place.path = path;
    return place;
}

void StationHandshakes::handleCookie(TimePoint now, const Path &from, ByteView datagram)
{
    for (Attempt &attempt : m_attempts) {
        if (attempt.uncookied == 0 || !attempt.handshake || attempt.carrier != from.carrier)
            continue;
        const auto cookie = openCookie(attempt.peer, ByteView(attempt.handshake->message()).last(kMacLength), datagram);
        if (!cookie)
            continue;
        --attempt.uncookied;
        attempt.unanswered = 0;
        Place &place = placeAt(attempt, from);
        place.cookie = cookie;
        place.cookieUntil = now + kCookieSecretLife;
        place.underCookie = true;
        // One copy for it and no more: whoever knows the key and saw one first message can make a cookie in any sender's
        // name, so it proves nothing about the address.
        sendTo(now, attempt, place);
        return;
    }
    ++m_core.unmatched.forged;
}

StationHandshakes::Attempt *StationHandshakes::attemptAnswered(const Path &from, ByteView datagram)
{
    const auto connection = answeredConnection(datagram);
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(), [&](const Attempt &a) {
        return a.handshake && connection && a.handshake->connection() == *connection && a.carrier == from.carrier;
    });
    return found == m_attempts.end() ? nullptr : &*found;
}

bool StationHandshakes::handleNumber(TimePoint now, const Path &from, ByteView datagram)
{
    Attempt *attempt = attemptAnswered(from, datagram);
    if (!attempt || !m_core.ownMac.verify(datagram)) {
        ++m_core.unmatched.forged;
        return false;
    }
    if (!mayCompute(now, *attempt))
        return true;
    const auto number = attempt->handshake->takeNumber(datagram);
    if (!number)
        return countWrong(now, *attempt);
    const bool skipped = *number >= attempt->handshake->counter() && *number <= kGreatestBelieved
        && m_core.counters.skipTo(*number);
    m_core.tellRefused(now, from, RefusalReason::CounterBehind, attempt->peer);
    Place &place = placeAt(*attempt, from);
    place.proven = true;
    if (renew(now, *attempt) && skipped)
        sendTo(now, *attempt, place);
    return true;
}

/// Whether another answer to the attempt's first message may cost us a computation. Where it may not, the true answer
/// would not be read either.
bool StationHandshakes::mayCompute(TimePoint now, Attempt &attempt)
{
    if (m_answers.take(now, kAnswersPerSecond, kAnswersAtOnce) || weakened(Weakness::NoRateLimit))
        return true;
    ++m_core.unmatched.malformed;
    giveUpFirst(now, attempt);
    return false;
}

/// One that was computed on in vain; true when that changed something.
bool StationHandshakes::countWrong(TimePoint now, Attempt &attempt)
{
    ++m_core.unmatched.forged;
    if (++attempt.wrong < kWrongAnswers || weakened(Weakness::NoRateLimit))
        return false;
    giveUpFirst(now, attempt);
    return true;
}

/// The next one has another connection id, which stands in it encrypted: nobody can forge answers to it before its own is
/// on the wire. What is sent to the old number costs nothing more.
void StationHandshakes::giveUpFirst(TimePoint now, Attempt &attempt)
{
    forgetFirst(attempt);
    attempt.flooded = true;
    attempt.due = attempt.freshFrom = std::max(now, attempt.begun + m_core.config.timing.handshakeRetry);
}

bool StationHandshakes::handleAnswer(TimePoint now, const Path &from, ByteView datagram)
{
    Attempt *found = attemptAnswered(from, datagram);
    if (!found) { // Also the second copy of an answer.
        ++m_core.unmatched.malformed;
        return false;
    }
    if (!m_core.ownMac.verify(datagram)) {
        ++m_core.unmatched.forged;
        m_core.tellRefused(now, from, RefusalReason::WrongKey, found->peer);
        return false;
    }
    if (!mayCompute(now, *found))
        return true;
    auto agreement = found->handshake->takeAnswer(datagram);
    if (!agreement) {
        m_core.tellRefused(now, from, agreement.error(), found->peer);
        return countWrong(now, *found);
    }
    const ConnectionId ours = found->handshake->connection();
    SessionSetup setup{m_core.table.number(ours),
                       true,
                       *m_core.peer(found->peer),
                       ours,
                       agreement->peerConnection,
                       std::move(agreement->peerOffer),
                       agreement->suite,
                       std::move(agreement->chain),
                       from};
    auto session = std::make_unique<Session>(std::move(setup), m_core.around, now);
    if (!session->usable()) {
        m_core.tellRefused(now, from, RefusalReason::NoCommonSuite, found->peer);
        giveUpFirst(now, *found);
        return true;
    }
    m_attempts.erase(m_attempts.begin() + (found - m_attempts.data())); // Its slot goes on as the session's.
    auto &entry = m_core.table.put(std::move(session), false, now);
    sessionLives(entry.session->peer().key); // the same wish in another carrier
    m_core.bringUp(now, entry);
    entry.session->handleDeadline(now); // The first report proves to the agent that we are no replay.
    return true;
}

std::vector<Unanswered> StationHandshakes::unanswered() const
{
    std::vector<Unanswered> out;
    for (const Attempt &attempt : m_attempts) {
        const Peer *peer = m_core.peer(attempt.peer);
        if (peer && attempt.announced && attempt.unanswered > 0)
            out.push_back({peer->key, peer->name, attempt.announcedFrom, attempt.unansweredSince, *attempt.announced,
                           attempt.unanswered});
    }
    return out;
}

void StationHandshakes::sessionLives(const PublicKey &peer)
{
    for (std::size_t i = m_attempts.size(); i-- > 0;) {
        if (m_attempts[i].peer == peer)
            drop(m_attempts[i]);
    }
}

void StationHandshakes::handleDeadline(TimePoint now)
{
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up || !entry.session->silent(now))
            return;
        const Path &path = entry.session->path();
        Attempt &attempt = want(now, entry.session->peer().key, path.carrier, now);
        placeAt(attempt, path).proven = true;
    });
    dropUnwanted(now);
    for (Attempt &attempt : m_attempts) {
        if (now >= attempt.due)
            send(now, attempt);
    }
}

TimePoint StationHandshakes::deadline(TimePoint now)
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

void StationHandshakes::send(TimePoint now, Attempt &attempt)
{
    const auto maySend = [](const Place &place) { return place.proven || place.owed || weakened(Weakness::RetryUnproven); };
    if (std::none_of(attempt.places.begin(), attempt.places.end(), maySend) || !ready(now, attempt)) {
        attempt.due = now + kLongestPause; // Until it is announced again.
        return;
    }
    TimePoint pausedUntil = kNever;
    bool sent = false;
    for (Place &place : attempt.places) {
        if (!maySend(place))
            continue;
        if (now < place.pausedUntil) {
            pausedUntil = std::min(pausedUntil, place.pausedUntil);
            continue;
        }
        sendTo(now, attempt, place);
        sent = true;
    }
    attempt.due = sent ? now + pauseAfter(attempt.sent++) : pausedUntil;
}

void StationHandshakes::sendTo(TimePoint now, Attempt &attempt, Place &place)
{
    FirstMessage message = attempt.handshake->message();
    const bool hasCookie = place.cookie && now < place.cookieUntil;
    if (hasCookie && place.underCookie)
        signWithCookie(*place.cookie, message);
    else
        attempt.uncookied = std::min(attempt.uncookied + 1, kCopies * static_cast<unsigned>(kMaxPlaces));
    place.underCookie = hasCookie && !place.underCookie;
    place.owed = false;
    place.lastSent = now;
    ++attempt.copies;
    if (attempt.unanswered++ == 0)
        attempt.unansweredSince = now;
    m_core.around.outbox.send(place.path, message);
}

/// A first message is there to be sent.
bool StationHandshakes::ready(TimePoint now, Attempt &attempt)
{
    if (attempt.handshake && (attempt.copies < kCopies || now < attempt.begun + kRenewAfter))
        return true;
    return now >= attempt.freshFrom && renew(now, attempt);
}

bool StationHandshakes::renew(TimePoint now, Attempt &attempt)
{
    const Peer *peer = m_core.peer(attempt.peer);
    if (!peer)
        return false;
    forgetFirst(attempt); // Each has a number of its own, so that what answers another costs nothing.
    const auto connection = m_core.table.reserve(m_core.around.random, attempt.flooded);
    if (!connection)
        return false;
    const std::uint64_t counter = m_core.counters.next();
    if (counter <= kGreatestCounter)
        attempt.handshake = Initiator::begin(*m_core.config.identity, *peer,
                                             FirstPayload{*connection, m_core.around.offer, counter}, m_core.around.random,
                                             attempt.carrier);
    else // Only a new key has counters left.
        m_core.tellRefused(now, attempt.places.front().path, RefusalReason::CountersUsedUp, attempt.peer);
    attempt.presharedKey = peer->presharedKey;
    attempt.copies = 0;
    attempt.uncookied = 0;
    attempt.wrong = 0;
    attempt.begun = now;
    if (!attempt.handshake)
        m_core.table.release(*connection);
    return attempt.handshake.has_value();
}

Duration StationHandshakes::pauseAfter(unsigned sent) const
{
    const Duration pause = std::min(kLongestPause, m_core.config.timing.handshakeRetry * (1 << std::min(sent, 8u)));
    // Up to a quarter more or less, so that stations which lost their agents at once do not call in step.
    std::uint8_t dice = 0;
    m_core.around.random.fill({&dice, 1});
    return pause * (384 + dice) / 512;
}

void StationHandshakes::drop(Attempt &attempt)
{
    forgetFirst(attempt);
    m_attempts.erase(m_attempts.begin() + (&attempt - m_attempts.data()));
}

void StationHandshakes::dropUnwanted(TimePoint now)
{
    for (std::size_t i = m_attempts.size(); i-- > 0;) {
        if (now >= m_attempts[i].wantedUntil)
            drop(m_attempts[i]);
    }
}

} // namespace skyseal::channel
