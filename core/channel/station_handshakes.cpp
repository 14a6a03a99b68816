#include "core/channel/station_handshakes.h"

#include <algorithm>
#include <utility>

namespace skyseal::channel {

namespace {

/// A first message is replaced after so many copies and so long. Copies are answered idempotently, and an answer may take long:
/// replayed announcements must not make us discard the message that it answers.
constexpr unsigned kCopies = 4;
constexpr Duration kRenewAfter = std::chrono::seconds(5);
constexpr unsigned kMostUncookied = kCopies * HandshakeAttempt::kMaxPlaces;
/// A greater counter reported by a peer is not accepted: no peer may use up the counters that we have for all peers.
constexpr std::uint64_t kGreatestBelieved = kGreatestCounter / 2;
constexpr Duration kLongestPause = std::chrono::seconds(2);
/// Lifetime of an attempt after the last announcement; after a call it ends with the turn.
constexpr Duration kWantedFor = std::chrono::seconds(10);
constexpr Duration kAnnouncementPause = std::chrono::milliseconds(50);
/// An answer costs two Diffie-Hellman computations before it is known to be false, and an eavesdropper can forge such answers:
/// the connection id of an answer is clear. Therefore a first message is given up, with its connection id, after so many wrong
/// answers, and the station computes on no more answers than an agent on first messages.
constexpr unsigned kWrongAnswers = 8;
constexpr double kAnswersPerSecond = 50;
constexpr double kAnswersAtOnce = 20;
constexpr unsigned kHashesOfCookie = 2;

} // namespace

StationHandshakes::StationHandshakes(EndpointCore &core) : m_core(core)
{
    peersChanged();
}

void StationHandshakes::peersChanged()
{
    m_known.setPeers(m_core.config.peers);
    for (Attempt &attempt : m_attempts) {
        const Peer *peer = m_core.peer(attempt.peer);
        if (!peer)
            attempt.wantedUntil = TimePoint::min();
        else if (attempt.first && !samePresharedKey(peer->presharedKey, attempt.first->presharedKey))
            discardFirst(attempt);
    }
    dropUnwanted(TimePoint::min());
}

void StationHandshakes::policyChanged()
{
    for (Attempt &attempt : m_attempts)
        discardFirst(attempt);
}

void StationHandshakes::discardFirst(Attempt &attempt)
{
    if (attempt.first)
        m_core.table.release(attempt.first->handshake.connection());
    attempt.first.reset();
}

StationHandshakes::Attempt *StationHandshakes::attemptWith(const PublicKey &peer, Carrier carrier)
{
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(),
                                    [&](const Attempt &a) { return a.peer == peer && a.carrier == carrier; });
    return found == m_attempts.end() ? nullptr : &*found;
}

StationHandshakes::Attempt &StationHandshakes::want(TimePoint until, const PublicKey &peer, Carrier carrier, TimePoint due)
{
    Attempt *attempt = attemptWith(peer, carrier);
    if (!attempt) {
        attempt = &m_attempts.emplace_back();
        attempt->peer = peer;
        attempt->carrier = carrier;
        attempt->due = due;
    }
    attempt->wantedUntil = std::max(attempt->wantedUntil, until);
    return *attempt;
}

bool StationHandshakes::handleAnnouncement(TimePoint now, const Path &from, ByteView datagram)
{
    if (!Announcement::hasForm(datagram)) {
        ++m_core.unmatched.malformed;
        return false;
    }
    const auto agent = m_known.announcer(now, from, datagram, m_core);
    if (!agent) {
        ++m_core.unmatched.forged;
        return false;
    }
    // While a session is up, an announcement is a replay or comes from an agent that has just restarted. It counts once the
    // session has been quiet for longer than an active one ever is.
    TimePoint due = now;
    if (const Session *session = m_core.table.upWith(*agent);
        session && !session->closing() && !mayReplace(*session, from.carrier))
        due = std::max(now, session->lastReceived() + m_core.config.timing.keepAliveAfter * 5 / 4);
    Attempt &attempt = want(now + kWantedFor, *agent, from.carrier, due);
    attempt.announced = now;
    attempt.announcedFrom = from;
    Place &place = attempt.placeAt(from);
    place.answerDue = true;
    // The agent is reachable, so answer at once: one copy for one announcement, and only to its source, so that an announcement
    // can neither hasten nor delay the copies to other addresses.
    if (due == now && (place.lastSent == TimePoint::min() || now >= place.lastSent + kAnnouncementPause)
        && prepareFirst(now, attempt)) {
        sendTo(now, attempt, place);
        place.pausedUntil = now + m_core.config.timing.handshakeRetry;
    }
    return true;
}

void StationHandshakes::handleCookie(TimePoint now, const Path &from, ByteView datagram)
{
    Cookie cookie{};
    Attempt *attempt = cookieHasForm(datagram) ? attemptOfCookie(now, from, datagram, cookie) : nullptr;
    if (!attempt) {
        ++m_core.unmatched.forged;
        return;
    }
    --attempt->first->uncookied;
    attempt->unanswered = 0;
    Place &place = attempt->placeAt(from);
    place.cookie = cookie;
    place.cookieUntil = now + kCookieSecretLife;
    place.underCookie = true;
    // A cookie proves nothing about the address: anyone who knows the agent's key and saw a first message can forge one
    // from any source. So it causes one copy and no more.
    sendTo(now, *attempt, place);
}

/// Returns the attempt whose first message the cookie answers, and the cookie; null if there is none or too many arrive.
StationHandshakes::Attempt *StationHandshakes::attemptOfCookie(TimePoint now, const Path &from, ByteView datagram,
                                                               Cookie &cookie)
{
    const auto opens = [&](const Attempt &attempt) {
        m_core.strangerHashes += kHashesOfCookie;
        const auto opened = openCookie(attempt.peer, ByteView(attempt.first->handshake.message()).last(kMacLength), datagram);
        cookie = opened.value_or(cookie);
        return opened.has_value();
    };
    const auto waitsForOne = [&](const Attempt &attempt) {
        return attempt.first && attempt.first->uncookied > 0 && attempt.carrier == from.carrier;
    };
    unsigned free = kFreeChecks;
    for (Attempt &attempt : m_attempts) {
        const auto isHere = [&](const Place &place) { return place.path == from; };
        if (free > 0 && waitsForOne(attempt) && std::any_of(attempt.places.begin(), attempt.places.end(), isHere)) {
            --free;
            if (opens(attempt))
                return &attempt;
        }
    }
    if (!m_known.mayCheck(now))
        return nullptr;
    for (Attempt &attempt : m_attempts) {
        if (!waitsForOne(attempt))
            continue;
        m_known.spend(kHashesOfCookie);
        if (opens(attempt))
            return &attempt;
    }
    return nullptr;
}

StationHandshakes::Attempt *StationHandshakes::attemptAnsweredBy(const Path &from, ByteView datagram)
{
    const auto connection = answeredConnection(datagram);
    const auto found = std::find_if(m_attempts.begin(), m_attempts.end(), [&](const Attempt &a) {
        return a.first && connection && a.first->handshake.connection() == *connection && a.carrier == from.carrier;
    });
    return found == m_attempts.end() ? nullptr : &*found;
}

/// Returns true for a reply to a first message whose session is up: the agent replies to each copy of the message.
bool StationHandshakes::isRepeated(ByteView datagram) const
{
    const auto connection = answeredConnection(datagram);
    return connection && m_core.table.find(*connection);
}

bool StationHandshakes::handleNumber(TimePoint now, const Path &from, ByteView datagram)
{
    Attempt *attempt = attemptAnsweredBy(from, datagram);
    if (!attempt && isRepeated(datagram)) {
        ++m_core.unmatched.replayed;
        return false;
    }
    m_core.strangerHashes += attempt != nullptr;
    if (!attempt || !m_core.ownMac.verify(datagram)) {
        ++m_core.unmatched.forged;
        return false;
    }
    if (!mayCompute(now, *attempt))
        return true;
    const auto number = attempt->first->handshake.readNumber(datagram);
    if (!number)
        return countWrongAnswer(now, *attempt);
    const bool skipped = *number >= attempt->first->handshake.counter() && *number <= kGreatestBelieved
        && m_core.counters.skipTo(*number);
    m_core.notifyRefused(now, from, RefusalReason::CounterBehind, attempt->peer);
    Place &place = attempt->placeAt(from);
    place.proven = true;
    if (makeFirst(now, *attempt) && skipped)
        sendTo(now, *attempt, place);
    return true;
}

/// Returns true if the station may compute on another answer to the first message. Otherwise gives the message up, since the
/// true answer would not be read either.
bool StationHandshakes::mayCompute(TimePoint now, Attempt &attempt)
{
    if (m_answers.take(now, kAnswersPerSecond, kAnswersAtOnce))
        return true;
    ++m_core.unmatched.malformed;
    giveUpFirst(now, attempt);
    return false;
}

/// An answer was wrong after a computation. Returns true if the first message was given up.
bool StationHandshakes::countWrongAnswer(TimePoint now, Attempt &attempt)
{
    ++m_core.unmatched.forged;
    if (++attempt.first->wrong < kWrongAnswers)
        return false;
    giveUpFirst(now, attempt);
    return true;
}

/// The next first message has another connection id, encrypted within it: nobody can forge an answer to it before the true
/// one is on the wire. Answers to the former id cost nothing any more.
void StationHandshakes::giveUpFirst(TimePoint now, Attempt &attempt)
{
    attempt.flooded = true;
    attempt.due = attempt.freshFrom = std::max(now, attempt.first->begun + m_core.config.timing.handshakeRetry);
    discardFirst(attempt);
}

bool StationHandshakes::handleAnswer(TimePoint now, const Path &from, ByteView datagram)
{
    Attempt *found = attemptAnsweredBy(from, datagram);
    if (!found) {
        ++(isRepeated(datagram) ? m_core.unmatched.replayed : m_core.unmatched.malformed);
        return false;
    }
    ++m_core.strangerHashes;
    if (!m_core.ownMac.verify(datagram)) {
        ++m_core.unmatched.forged;
        m_core.notifyRefused(now, from, RefusalReason::WrongKey, found->peer);
        return false;
    }
    if (!mayCompute(now, *found))
        return true;
    auto agreement = found->first->handshake.readAnswer(datagram);
    if (!agreement) {
        m_core.notifyRefused(now, from, agreement.error(), found->peer);
        return countWrongAnswer(now, *found);
    }
    const ConnectionId ours = found->first->handshake.connection();
    SessionSetup setup{{m_core.table.number(ours), true, *m_core.peer(found->peer), ours, agreement->peerConnection},
                       std::move(agreement->peerOffer),
                       agreement->suite,
                       std::move(agreement->chain),
                       from};
    auto session = std::make_unique<Session>(std::move(setup), m_core.context, now);
    if (!session->usable()) {
        m_core.notifyRefused(now, from, RefusalReason::NoCommonSuite, found->peer);
        giveUpFirst(now, *found);
        return true;
    }
    m_attempts.erase(m_attempts.begin() + (found - m_attempts.data())); // The session keeps its slot.
    auto &entry = m_core.table.put(std::move(session), false, now);
    sessionLives(*entry.session); // ends the attempt on another carrier, too
    for (Attempt &attempt : m_attempts)
        attempt.stopCallingAt({&from, 1}); // other agents would only refuse first messages there
    m_core.bringUp(now, entry);
    entry.session->handleDeadline(now); // The first report proves that our handshake is not replayed.
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

void StationHandshakes::sessionLives(const Session &session)
{
    for (std::size_t i = m_attempts.size(); i-- > 0;) {
        if (m_attempts[i].peer == session.peer().key && !mayReplace(session, m_attempts[i].carrier))
            drop(m_attempts[i]);
    }
}

/// A session cannot follow its peer to another carrier. If an agent receives nothing on the carrier of its session, a new
/// session on another carrier replaces the session, although the records of the agent arrive.
bool StationHandshakes::mayReplace(const Session &session, Carrier carrier)
{
    return session.peerReceivesNothing() && carrier != session.path().carrier;
}

void StationHandshakes::callAgents(TimePoint now)
{
    if (m_core.config.callAt.empty() || now < m_calls.nextTurn())
        return;
    std::vector<PublicKey> agents;
    for (const Peer &peer : m_core.config.peers) {
        if (!m_core.table.upWith(peer.key))
            agents.push_back(peer.key);
    }
    std::vector<Path> places = m_core.config.callAt;
    std::erase_if(places, [this, now](const Path &path) { return isTaken(now, path); });
    const AgentCalls::Turn turn = m_calls.take(now, agents, places);
    for (Attempt &attempt : m_attempts) { // The last turn ends here.
        std::vector<Path> ended = m_core.config.callAt;
        if (std::ranges::find(turn.agents, attempt.peer) != turn.agents.end())
            std::erase_if(ended, [&](const Path &path) { return std::ranges::find(turn.places, path) != turn.places.end(); });
        attempt.stopCallingAt(ended);
    }
    for (const PublicKey &agent : turn.agents) {
        for (const Path &path : turn.places) {
            Attempt &attempt = want(now + AgentCalls::kTurn, agent, path.carrier, now);
            Place &place = attempt.placeAt(path);
            if (place.lastSent == TimePoint::min())
                attempt.due = now;
            place.proven = true; // The operator named it.
        }
    }
}

/// Returns true if the agent that listens there has a session in which records arrive.
bool StationHandshakes::isTaken(TimePoint now, const Path &place)
{
    bool taken = false;
    m_core.table.forEach([&](const SessionTable::Entry &entry) {
        taken = taken || (entry.up && !entry.session->silent(now) && entry.session->path() == place);
    });
    return taken;
}

void StationHandshakes::setCallAt(std::vector<Path> paths)
{
    std::vector<Path> removed = std::exchange(m_core.config.callAt, std::move(paths));
    std::erase_if(
        removed, [&](const Path &path) { return std::ranges::find(m_core.config.callAt, path) != m_core.config.callAt.end(); });
    for (Attempt &attempt : m_attempts)
        attempt.stopCallingAt(removed);
}

void StationHandshakes::handleDeadline(TimePoint now)
{
    callAgents(now);
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up || !entry.session->silent(now))
            return;
        const Path &path = entry.session->path();
        Attempt &attempt = want(now + kWantedFor, entry.session->peer().key, path.carrier, now);
        attempt.placeAt(path).proven = true;
    });
    dropUnwanted(now);
    for (Attempt &attempt : m_attempts) {
        if (now >= attempt.due)
            send(now, attempt);
    }
}

TimePoint StationHandshakes::deadline(TimePoint now)
{
    TimePoint due = m_core.config.callAt.empty() ? kNever : m_calls.nextTurn();
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
    const auto maySend = [](const Place &place) { return place.proven || place.answerDue; };
    if (std::none_of(attempt.places.begin(), attempt.places.end(), maySend) || !prepareFirst(now, attempt)) {
        attempt.due = attempt.freshFrom > now ? attempt.freshFrom : now + kLongestPause; // or the next announcement
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
    FirstMessage message = attempt.first->handshake.message();
    const bool hasCookie = place.cookie && now < place.cookieUntil;
    if (hasCookie && place.underCookie)
        signWithCookie(*place.cookie, message);
    else
        attempt.first->uncookied = std::min(attempt.first->uncookied + 1, kMostUncookied);
    place.underCookie = hasCookie && !place.underCookie;
    place.answerDue = false;
    place.lastSent = now;
    ++attempt.first->copies;
    if (attempt.unanswered++ == 0)
        attempt.unansweredSince = now;
    m_core.context.outgoing.push(place.path, message);
}

/// Returns true if the attempt has a first message to send; makes a new one where that is due.
bool StationHandshakes::prepareFirst(TimePoint now, Attempt &attempt)
{
    if (attempt.first && (attempt.first->copies < kCopies || now < attempt.first->begun + kRenewAfter))
        return true;
    return now >= attempt.freshFrom && makeFirst(now, attempt);
}

bool StationHandshakes::makeFirst(TimePoint now, Attempt &attempt)
{
    const Peer *peer = m_core.peer(attempt.peer);
    if (!peer)
        return false;
    discardFirst(attempt); // Each message has a connection id of its own, so that answers to another one cost nothing.
    const std::optional<std::uint64_t> counter = m_core.counters.next();
    if (!counter) { // The next ones are being stored.
        attempt.due = attempt.freshFrom = now + m_core.config.timing.handshakeRetry;
        return false;
    }
    const auto connection = m_core.table.reserve(m_core.context.random, attempt.flooded);
    if (!connection)
        return false;
    std::optional<Initiator> handshake;
    if (*counter <= kGreatestCounter)
        handshake = Initiator::begin(*m_core.config.identity, *peer, FirstPayload{*connection, m_core.context.offer, *counter},
                                     m_core.context.random, attempt.carrier);
    else
        m_core.notifyRefused(now, attempt.places.front().path, RefusalReason::CountersUsedUp, attempt.peer);
    if (!handshake) {
        m_core.table.release(*connection);
        return false;
    }
    attempt.first.emplace(HandshakeAttempt::First{std::move(*handshake), peer->presharedKey, now});
    return true;
}

Duration StationHandshakes::pauseAfter(unsigned sent) const
{
    const Duration pause = std::min(kLongestPause, m_core.config.timing.handshakeRetry * (1 << std::min(sent, 8u)));
    // Jitter of a quarter, so that stations that lost their agents at the same time do not send in step.
    std::uint8_t dice = 0;
    m_core.context.random.fill({&dice, 1});
    return pause * (384 + dice) / 512;
}

void StationHandshakes::drop(Attempt &attempt)
{
    discardFirst(attempt);
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
