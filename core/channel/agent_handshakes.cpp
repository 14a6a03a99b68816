#include "core/channel/agent_handshakes.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kFloodPause = std::chrono::seconds(10);
constexpr Duration kNumberPause = std::chrono::milliseconds(200);
constexpr Duration kAnswerKept = std::chrono::seconds(10);
/// Answers that wait for their station, of one peer and in all. One of a peer would do if only it could write first
/// messages in its name.
constexpr std::ptrdiff_t kMostAnsweredOfPeer = 4;
constexpr std::size_t kMostAnswered = 64;

bool holds(const std::vector<Path> &paths, const Path &path)
{
    return std::find(paths.begin(), paths.end(), path) != paths.end();
}

} // namespace

AgentHandshakes::AgentHandshakes(EndpointCore &core, TimePoint now)
    : m_core(core), m_announcement(core.config.identity->publicKey), m_announced(now - core.config.timing.announceBesideEvery),
      m_limit(core.around.random, now), m_cookies(core.config.identity->publicKey, core.around.random),
      m_floodNotified(TimePoint::min()), m_numberNotified(TimePoint::min())
{}

bool AgentHandshakes::handleFirst(TimePoint now, const Path &from, ByteView datagram)
{
    const bool proven = !m_core.ownMac.verify(datagram);
    if (proven && !m_cookies.verify(now, from, datagram))
        return refuse(now, from, RefusalReason::WrongKey);
    const ByteView said = datagram.first(kFirstLength - kMacLength);
    for (const Answered &answered : m_answered) {
        // A copy: our answer may have been lost. The same one again, and nothing is computed.
        if (std::equal(said.begin(), said.end(), answered.first.begin())) {
            m_core.around.outbox.send(from, answered.answer);
            if (weakened(Weakness::AnswerTwice))
                m_core.around.outbox.send(from, answered.answer);
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
    // Written down only once the station has proved itself alive: until then a replay gains nothing, and whoever could
    // forge a first message (with our own key stolen) must not be able to spend the station's numbers. For the same reason
    // answers that nobody confirmed have no say in it.
    const std::uint64_t counter = responder->payload().counter;
    if (counter <= m_core.counters.lastSeen(key) && !weakened(Weakness::AcceptLowerCounter)) {
        tellNumber(now, from, *peer, std::move(*responder));
        return refuse(now, from, RefusalReason::ReplayedHandshake, key);
    }

    // A station that still has the old session takes this as its answer; one that has restarted ignores it. It and the answer
    // are shorter than the message: who repeats one is not given more than he sends.
    if (Session *old = m_core.table.upWith(key))
        old->showLife(now);

    makeRoomFor(key);
    const auto connection = m_core.table.reserve(m_core.around.random);
    if (!connection)
        return false;
    auto answer = std::move(*responder).answer(*peer, *connection, m_core.around.offer, m_core.around.random);
    if (!answer) {
        m_core.table.release(*connection);
        return refuse(now, from, answer.error(), key);
    }
    if (SessionTable::Entry *here = m_core.table.upAt(from))
        here->session->nameRecordsUntil(now + kAnswerKept); // the station may have a new session there before we know it
    Agreement &agreement = answer->agreement;
    SessionSetup setup{m_core.table.number(*connection),
                       false,
                       *peer,
                       *connection,
                       agreement.peerConnection,
                       std::move(agreement.peerOffer),
                       agreement.suite,
                       std::move(agreement.chain),
                       from};
    auto session = std::make_unique<Session>(std::move(setup), m_core.around, now);
    if (!session->usable()) {
        m_core.table.release(*connection);
        return refuse(now, from, RefusalReason::NoCommonSuite, key);
    }
    Answered answered{key, counter, session->id(), now + kAnswerKept, {}, answer->message};
    std::copy(datagram.begin(), datagram.end(), answered.first.begin());
    m_answered.push_back(answered);
    auto &entry = m_core.table.put(std::move(session), false, now);
    m_core.around.outbox.send(from, answer->message);
    if (weakened(Weakness::AnswerTwice))
        m_core.around.outbox.send(from, answer->message);
    if (weakened(Weakness::NoConfirmation))
        return confirm(now, entry);
    return true;
}

/// A station that lost its counters would be refused until it has counted up again. Nobody else can read the number, and
/// nothing changes here, so a replay gains nothing by it.
void AgentHandshakes::tellNumber(TimePoint now, const Path &from, const Peer &peer, Responder &&responder)
{
    const std::uint64_t lastSeen = m_core.counters.lastSeen(peer.key);
    if (now < m_numberNotified + kNumberPause)
        return;
    m_numberNotified = now;
    if (const auto message = std::move(responder).tellNumber(peer, lastSeen, m_core.around.random))
        m_core.around.outbox.send(from, *message);
}

template<typename Which> void AgentHandshakes::forgetIf(Which which)
{
    std::erase_if(m_answered, [&](const Answered &answered) {
        if (!which(answered))
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
        forgetIf(isIts);
        return false;
    }
    std::erase_if(m_answered, isIts);
    // Lower ones are old by now: a station's earlier attempts, and replays.
    forgetIf([&](const Answered &a) { return a.peer == peer && a.counter <= counter; });
    m_core.bringUp(now, entry);
    return true;
}

/// The one with the peer's greatest counter, and the first of several such.
const AgentHandshakes::Answered *AgentHandshakes::furthestOf(const PublicKey &peer) const
{
    const Answered *found = nullptr;
    for (const Answered &answered : m_answered) {
        if (answered.peer == peer && (!found || answered.counter > found->counter))
            found = &answered;
    }
    return found;
}

/// Who repeats a station's older messages cannot displace the newest, and who has our key and makes up counters cannot
/// keep the others out: the oldest goes that is not its peer's furthest.
void AgentHandshakes::makeRoomFor(const PublicKey &peer)
{
    const bool full = m_answered.size() >= kMostAnswered;
    const auto ofPeer = std::count_if(m_answered.begin(), m_answered.end(), [&](const Answered &a) { return a.peer == peer; });
    if (ofPeer < kMostAnsweredOfPeer && !full)
        return;
    const auto found = std::find_if(m_answered.begin(), m_answered.end(),
                                    [&](const Answered &a) { return (full || a.peer == peer) && &a != furthestOf(a.peer); });
    if (found != m_answered.end())
        forgetIf([session = found->session](const Answered &a) { return a.session == session; });
}

void AgentHandshakes::peersChanged()
{
    forgetIf([this](const Answered &answered) {
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
    m_core.tellRefused(now, from, reason, peer);
    return false;
}

bool AgentHandshakes::mayCompute(TimePoint now, const Path &from, ByteView datagram, bool proven)
{
    if (weakened(Weakness::NoRateLimit))
        return true;
    if (proven || !m_limit.underLoad(now) || weakened(Weakness::NoCookie))
        return m_limit.admit(now, from, !proven ? Standing::Claimed : expects(from) ? Standing::Expected : Standing::Proven);
    // Room is left for what matters more.
    if (m_core.around.outbox.size() < DatagramQueue::kSlots / 2)
        m_core.around.outbox.send(from, m_cookies.make(now, from, datagram));
    if (now >= m_floodNotified) {
        m_core.around.events.emplace_back(HandshakeRefused{from, RefusalReason::Flood, {}});
        m_floodNotified = now + kFloodPause;
    }
    return false;
}

/// Whether a station may well be at that host: we announce ourselves there, or have a session with it.
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
    Targets out{m_core.config.announceTo, m_core.config.timing.announceEvery};
    std::vector<Path> served;
    std::size_t peersServed = 0;
    m_core.table.forEach([&](SessionTable::Entry &entry) {
        if (!entry.up)
            return;
        const Session &session = *entry.session;
        if (now < session.quietFrom()) {
            served.push_back(session.path());
            served.push_back(session.origin());
            ++peersServed; // who has one session at most
        } else if (!holds(out.paths, session.path())) {
            out.paths.push_back(session.path());
        }
    });
    std::erase_if(out.paths, [&](const Path &target) { return holds(served, target); });

    // More stations than the one that is served may be on a link: behind a router, at a listening port, at another address.
    // Who came first must not keep the others from ever hearing of us.
    const auto sharesLink = [&](const Path &target) {
        return std::any_of(served.begin(), served.end(), [&](const Path &path) { return path.link == target.link; });
    };
    if (peersServed >= m_core.config.peers.size())
        std::erase_if(out.paths, sharesLink);
    else if (std::all_of(out.paths.begin(), out.paths.end(), sharesLink))
        out.every = m_core.config.timing.announceBesideEvery;
    return out;
}

void AgentHandshakes::handleDeadline(TimePoint now)
{
    forgetIf([now](const Answered &answered) { return now >= answered.until; });
    const Targets targets = announceTargets(now);
    if (targets.paths.empty() || now < announceDue(targets))
        return;
    const auto datagram = m_announcement.make(m_core.around.random);
    for (const Path &path : targets.paths)
        m_core.around.outbox.send(path, datagram);
    m_announced = now;
}

TimePoint AgentHandshakes::deadline(TimePoint now)
{
    TimePoint due = kNever;
    for (const Answered &answered : m_answered)
        due = std::min(due, answered.until);
    if (const Targets targets = announceTargets(now); !targets.paths.empty())
        due = std::min(due, announceDue(targets));
    m_core.table.forEach([&](SessionTable::Entry &entry) { // which is announced to then
        if (entry.up && now < entry.session->quietFrom())
            due = std::min(due, entry.session->quietFrom());
    });
    return due;
}

TimePoint AgentHandshakes::announceDue(const Targets &targets) const
{
    return m_announced + targets.every;
}

} // namespace skyseal::channel
