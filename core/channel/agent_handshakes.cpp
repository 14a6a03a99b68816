#include "core/channel/agent_handshakes.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kFloodEventInterval = std::chrono::seconds(10);
constexpr Duration kNumberInterval = std::chrono::milliseconds(200);
constexpr Duration kAnswerKept = std::chrono::seconds(10);
/// Unconfirmed answers, of one peer and in total. One per peer would be enough if only the peer itself could write first
/// messages in its name.
constexpr std::ptrdiff_t kMostAnsweredOfPeer = 4;
constexpr std::size_t kMostAnswered = 64;
/// Datagrams of one round, so that those of many quiet sessions, whose reports may be due at once, do not fill the queue.
constexpr std::size_t kMostAnnouncements = 48;
constexpr std::size_t kMostRequests = 16;
static_assert(SessionTable::kSlots + 2 * kMostAnnouncements + kMostRequests <= DatagramQueue::kSlots);

bool holds(const std::vector<Path> &paths, const Path &path)
{
    return std::find(paths.begin(), paths.end(), path) != paths.end();
}

} // namespace

AgentHandshakes::AgentHandshakes(EndpointCore &core, TimePoint now)
    : m_core(core), m_announcement(core.config.identity->publicKey), m_beside{now - core.config.timing.announceBesideEvery},
      m_alone(m_beside), m_requests(core.config.timing.announceEvery, now), m_limit(core.context.random, now),
      m_cookies(core.config.identity->publicKey, core.context.random), m_floodEvents(kFloodEventInterval, now),
      m_numbers(kNumberInterval, now)
{}

bool AgentHandshakes::handleFirst(TimePoint now, const Path &from, ByteView datagram)
{
    ++m_core.strangerHashes;
    const bool proven = !m_core.ownMac.verify(datagram);
    m_core.strangerHashes += proven ? 2 : 0; // one under each of the two secrets
    if (proven && !m_cookies.verify(now, from, datagram))
        return refuse(now, from, RefusalReason::WrongKey);
    const ByteView content = datagram.first(kFirstLength - kMacLength);
    for (const Answered &answered : m_answered) {
        // A copy: our answer may have been lost. Send the same one again, without a computation.
        if (std::equal(content.begin(), content.end(), answered.first.begin())) {
            m_core.context.outgoing.push(from, answered.answer);
            return false;
        }
    }
    if (!mayCompute(now, from, datagram, proven))
        return false;
    auto responder = Responder::read(*m_core.config.identity, datagram, from.carrier);
    if (!responder)
        return refuse(now, from, responder.error());
    const PublicKey key = responder->peer();
    const Peer *peer = m_core.peer(key);
    if (!peer)
        return refuse(now, from, RefusalReason::UnknownPeer, key);
    // The counter is stored only when the station has confirmed the session: until then a replay gains nothing, and an attacker
    // with our own key, who can forge first messages, must not be able to use up the station's counters. For the same reason
    // the counters of unconfirmed answers do not count here.
    const std::uint64_t counter = responder->payload().counter;
    if (counter <= m_core.counters.lastSeen(key)) {
        sendNumber(now, from, *peer, std::move(*responder));
        return refuse(now, from, RefusalReason::ReplayedHandshake, key);
    }

    // A station that still has the old session keeps it when it receives this; one that has restarted ignores it. This record
    // and the answer are together shorter than the first message, so that replaying one yields no amplification.
    if (Session *old = m_core.table.upWith(key))
        old->sendKeepAlive(now);

    if (!responder->hasCommonSuite(m_core.context.offer))
        return refuse(now, from, RefusalReason::NoCommonSuite, key);
    makeRoomFor(key);
    const auto connection = m_core.table.reserve(m_core.context.random);
    if (!connection)
        return false;
    auto answer = std::move(*responder).answer(*peer, *connection, m_core.context.offer, m_core.context.random);
    if (!answer) {
        m_core.table.release(*connection);
        return refuse(now, from, answer.error(), key);
    }
    if (SessionTable::Entry *here = m_core.table.upAt(from))
        here->session->nameRecordsUntil(now + kAnswerKept); // The station may use a new session there before we know.
    Agreement &agreement = answer->agreement;
    SessionSetup setup{{m_core.table.number(*connection), false, *peer, *connection, agreement.peerConnection},
                       std::move(agreement.peerOffer),
                       agreement.suite,
                       std::move(agreement.chain),
                       from};
    auto session = std::make_unique<Session>(std::move(setup), m_core.context, now);
    if (!session->usable()) {
        m_core.table.release(*connection);
        return refuse(now, from, RefusalReason::NoCommonSuite, key);
    }
    Answered answered{key, counter, session->id(), now + kAnswerKept, {}, answer->message};
    std::copy(datagram.begin(), datagram.end(), answered.first.begin());
    m_answered.push_back(answered);
    m_core.table.put(std::move(session), false, now);
    m_core.context.outgoing.push(from, answer->message);
    return true;
}

/// Without the number, a station that lost its counters would be refused until it has counted up again. Only that station can
/// read it, and nothing changes here, so that a replay gains nothing.
void AgentHandshakes::sendNumber(TimePoint now, const Path &from, const Peer &peer, Responder &&responder)
{
    if (!m_numbers.take(now))
        return;
    const std::uint64_t lastSeen = m_core.counters.lastSeen(peer.key);
    if (const auto message = std::move(responder).writeNumber(peer, lastSeen, m_core.context.random))
        m_core.context.outgoing.push(from, *message);
}

template<typename Condition> void AgentHandshakes::discardIf(Condition condition)
{
    std::erase_if(m_answered, [&](const Answered &answered) {
        if (!condition(answered))
            return false;
        m_core.table.erase(answered.session);
        return true;
    });
}

bool AgentHandshakes::confirm(TimePoint now, SessionTable::Entry &entry)
{
    const PublicKey peer = entry.session->peer().key;
    const auto isIts = [session = entry.session->id()](const Answered &a) { return a.session == session; };
    const auto confirmed = std::find_if(m_answered.begin(), m_answered.end(), isIts);
    const std::uint64_t counter = confirmed == m_answered.end() ? 0 : confirmed->counter;
    if (!m_core.counters.remember(peer, counter)) {
        discardIf(isIts);
        return false;
    }
    std::erase_if(m_answered, isIts);
    // Lower counters are those of the station's earlier attempts, or replays.
    discardIf([&](const Answered &a) { return a.peer == peer && a.counter <= counter; });
    m_core.bringUp(now, entry);
    return true;
}

/// Returns the answer to the first message with the peer's greatest counter, the oldest of several.
const AgentHandshakes::Answered *AgentHandshakes::greatestOf(const PublicKey &peer) const
{
    const Answered *found = nullptr;
    for (const Answered &answered : m_answered) {
        if (answered.peer == peer && (!found || answered.counter > found->counter))
            found = &answered;
    }
    return found;
}

/// Discards the oldest answer that does not have its peer's greatest counter. So replayed older messages of a station cannot
/// displace its newest one, and an attacker with our key who invents counters cannot keep others out. If each has, as when he
/// writes in the name of many peers, the oldest goes: at the rate that the agent computes it had a second to be confirmed.
void AgentHandshakes::makeRoomFor(const PublicKey &peer)
{
    const bool full = m_answered.size() >= kMostAnswered;
    const auto ofPeer = std::count_if(m_answered.begin(), m_answered.end(), [&](const Answered &a) { return a.peer == peer; });
    if (ofPeer < kMostAnsweredOfPeer && !full)
        return;
    auto found = std::find_if(m_answered.begin(), m_answered.end(),
                              [&](const Answered &a) { return (full || a.peer == peer) && &a != greatestOf(a.peer); });
    if (found == m_answered.end() && full)
        found = m_answered.begin();
    if (found != m_answered.end())
        discardIf([session = found->session](const Answered &a) { return a.session == session; });
}

void AgentHandshakes::peersChanged()
{
    discardIf([this](const Answered &answered) {
        const SessionTable::Entry *entry = m_core.table.find(answered.session);
        const Peer *peer = m_core.peer(answered.peer);
        return !entry || !peer || !samePresharedKey(peer->presharedKey, entry->session->peer().presharedKey);
    });
}

bool AgentHandshakes::refuse(TimePoint now, const Path &from, RefusalReason reason, const PublicKey &peer)
{
    if (reason == RefusalReason::ReplayedHandshake)
        ++m_core.unmatched.replayed;
    else
        ++m_core.unmatched.forged;
    m_core.notifyRefused(now, from, reason, peer);
    return false;
}

bool AgentHandshakes::mayCompute(TimePoint now, const Path &from, ByteView datagram, bool proven)
{
    if (proven || !m_limit.underLoad(now))
        return m_limit.admit(now, from, !proven ? Standing::Claimed : expects(from) ? Standing::Expected : Standing::Proven);
    // Cookies may use half of the queue only.
    if (m_core.context.outgoing.size() < DatagramQueue::kSlots / 2)
        m_core.context.outgoing.push(from, m_cookies.make(now, from, datagram));
    if (m_floodEvents.take(now))
        m_core.context.events.emplace_back(HandshakeRefused{from, RefusalReason::Flood, {}});
    return false;
}

/// Returns true if a station is expected at this host: the agent announces itself there, or has a session with it.
bool AgentHandshakes::expects(const Path &from)
{
    const auto isHostOf = [&from](const Path &path) {
        return path.link == from.link && path.remote.ip == from.remote.ip && path.remote.ip != Address{}.ip;
    };
    const auto &announced = m_core.config.announceTo;
    bool found = std::any_of(announced.begin(), announced.end(), isHostOf);
    m_core.table.forEach([&](SessionTable::Entry &entry) { found = found || (entry.up && isHostOf(entry.session->path())); });
    return found;
}

AgentHandshakes::Targets AgentHandshakes::announceTargets(TimePoint now)
{
    std::vector<Path> paths = m_core.config.announceTo;
    std::vector<Path> served;
    std::size_t peersServed = 0;
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up)
            return;
        const Session &session = *entry.session;
        if (!session.quiet(now)) {
            served.push_back(session.path());
            if (session.origin().link == session.path().link) // otherwise it is another path to the same station
                served.push_back(session.origin());
            ++peersServed; // a peer has one session at most
        } else if (!holds(paths, session.path())) {
            paths.push_back(session.path());
        }
    });
    // A link may lead to more stations than the one with a session: behind a router, at a listening port, at another address.
    // The first station must not prevent the others from finding the agent.
    const bool allServed = peersServed >= m_core.config.peers.size();
    Targets out;
    for (const Path &path : paths) {
        const bool sharesLink = std::any_of(served.begin(), served.end(),
                                            [&](const Path &one) { return one.link == path.link; });
        if (!sharesLink)
            out.alone.push_back(path);
        else if (!allServed && !holds(served, path))
            out.beside.push_back(path);
    }
    return out;
}

void AgentHandshakes::handleDeadline(TimePoint now)
{
    discardIf([now](const Answered &answered) { return now >= answered.until; });
    const Targets targets = announceTargets(now);
    announce(now, m_alone, targets.alone, m_core.config.timing.announceEvery);
    announce(now, m_beside, targets.beside, m_core.config.timing.announceBesideEvery);
    requestReports(now);
}

/// Announces to as many of the addresses as a round allows, in turn: many sessions may be quiet at the same time.
void AgentHandshakes::announce(TimePoint now, Rounds &rounds, const std::vector<Path> &targets, Duration every)
{
    if (now < rounds.due(targets, every))
        return;
    rounds.latest = now;
    const auto datagram = m_announcement.make(m_core.context.random);
    const std::size_t count = std::min(targets.size(), kMostAnnouncements);
    for (std::size_t i = 0; i < count; ++i)
        m_core.context.outgoing.push(targets[rounds.turn++ % targets.size()], datagram);
}

/// Quiet sessions try the configured addresses of their carrier, since an announcement alone would not bring their peer there
/// while it still receives our records. A bounded number of them at a time, in turn.
void AgentHandshakes::requestReports(TimePoint now)
{
    struct Request
    {
        Session *session;
        Path to;
    };
    std::vector<Request> requests;
    bool anyQuiet = false;
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up || !entry.session->quiet(now))
            return;
        anyQuiet = true;
        const Path used = entry.session->path();
        for (const Path &path : m_core.config.announceTo) {
            // A target without an address or a node of its own leads to all peers of its link, including this one.
            const bool isSamePlace = path.link == used.link && (path.remote == Address{} || path.remote == used.remote);
            if (path.carrier == used.carrier && !isSamePlace)
                requests.push_back({entry.session.get(), path});
        }
    });
    if (!anyQuiet || !m_requests.take(now))
        return;
    const std::size_t count = std::min(requests.size(), kMostRequests);
    for (std::size_t i = 0; i < count; ++i) {
        const Request &request = requests[m_requestTurn++ % requests.size()];
        request.session->requestReportAt(now, request.to);
    }
}

TimePoint AgentHandshakes::deadline(TimePoint now)
{
    TimePoint due = announceDue(announceTargets(now));
    for (const Answered &answered : m_answered)
        due = std::min(due, answered.until);
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up) // From then on it is announced to, and requests reports.
            due = std::min(due, entry.session->quiet(now) ? m_requests.next() : entry.session->quietFrom());
    });
    return due;
}

TimePoint AgentHandshakes::announceDue(const Targets &targets) const
{
    const auto &timing = m_core.config.timing;
    return std::min(m_alone.due(targets.alone, timing.announceEvery), m_beside.due(targets.beside, timing.announceBesideEvery));
}

} // namespace skyseal::channel
