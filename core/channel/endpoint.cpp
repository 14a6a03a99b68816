#include "core/channel/endpoint.h"

#include "core/channel/agent_handshakes.h"
#include "core/channel/endpoint_core.h"
#include "core/channel/frame_stamp.h"
#include "core/channel/inline_frame.h"
#include "core/channel/station_handshakes.h"

#include <algorithm>
#include <utility>

namespace skyseal::channel {

struct Endpoint::State
{
    State(Config config, RandomSource &random, CounterStore &counters, TimePoint start)
        : core(std::move(config), random, counters), now(start)
    {
        if (core.config.role == Role::Station)
            stationHandshakes.emplace(core);
        else
            agentHandshakes.emplace(core, now);
        refresh(now);
    }

    /// Call after each change of a timer and each end of a session.
    void refresh(TimePoint at);
    void handleDeadline(TimePoint at);
    std::optional<Delivery> handleRecord(TimePoint at, const Path &from, MutableByteView datagram);
    std::optional<Delivery> handleInlineFrame(TimePoint at, const Path &from, MutableByteView bytes);
    void afterOpening(const SessionTable::Entry &entry, const Session::Opened &opened);
    void handleHandshake(TimePoint at, const Path &from, ByteView datagram);

    EndpointCore core;
    std::optional<StationHandshakes> stationHandshakes; ///< of a station's endpoint
    std::optional<AgentHandshakes> agentHandshakes;     ///< of an agent's endpoint
    TimePoint deadline = kNever;
    TimePoint now; ///< of the last input or command
};

void Endpoint::State::refresh(TimePoint at)
{
    now = at;
    core.endFinished(now);
    deadline = stationHandshakes ? stationHandshakes->deadline(now) : agentHandshakes->deadline(now);
    core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up)
            deadline = std::min(deadline, entry.session->deadline());
    });
}

void Endpoint::State::handleDeadline(TimePoint at)
{
    now = at;
    core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up)
            entry.session->handleDeadline(now);
    });
    core.endFinished(now);
    if (stationHandshakes)
        stationHandshakes->handleDeadline(now);
    else
        agentHandshakes->handleDeadline(now);
    refresh(now);
}

std::optional<Delivery> Endpoint::State::handleRecord(TimePoint at, const Path &from, MutableByteView datagram)
{
    now = at;
    std::optional<Delivery> delivery; // named return value: constructed in place in the caller
    const auto header = RecordHeader::read(datagram);
    SessionTable::Entry *entry = nullptr;
    if (header && header->kind == DatagramKind::Record)
        entry = core.table.find(header->connection);
    else if (header && from.carrier == Carrier::Serial)
        entry = core.table.upAt(from);
    if (!entry) {
        ++core.unmatched.malformed;
        return delivery;
    }
    const auto opened = entry->session->open(now, from, *header, datagram, delivery);
    if (opened.authentic && !entry->up && !agentHandshakes->confirm(now, *entry)) {
        delivery.reset();
        return delivery;
    }
    afterOpening(*entry, opened);
    return delivery;
}

std::optional<Delivery> Endpoint::State::handleInlineFrame(TimePoint at, const Path &from, MutableByteView bytes)
{
    now = at;
    std::optional<Delivery> delivery;
    const MessageTraits *traits = core.context.traits;
    const auto frame = traits ? InlineFrame::read(bytes, *traits) : std::nullopt;
    SessionTable::Entry *entry = core.table.upAt(from);
    if (!entry)
        ++core.unmatched.malformed;
    else if (!frame)
        entry->session->countMalformed();
    else
        afterOpening(*entry, entry->session->openInline(now, *frame, delivery));
    return delivery;
}

void Endpoint::State::afterOpening(const SessionTable::Entry &entry, const Session::Opened &opened)
{
    if (opened.authentic && stationHandshakes && !stationHandshakes->idle())
        stationHandshakes->sessionLives(*entry.session);
    if (!opened.routine)
        handleDeadline(now);
}

void Endpoint::State::handleHandshake(TimePoint at, const Path &from, ByteView datagram)
{
    now = at;
    const auto message = static_cast<HandshakeMessage>(datagram[0] & 3);
    if (message == HandshakeMessage::First && agentHandshakes && datagram.size() == kFirstLength) {
        if (!agentHandshakes->handleFirst(now, from, datagram))
            return; // refused, perhaps one of a flood: no timer has changed
    } else if (message == HandshakeMessage::Answer && stationHandshakes) {
        if (!stationHandshakes->handleAnswer(now, from, datagram))
            return;
    } else if (message == HandshakeMessage::Cookie && stationHandshakes && datagram.size() == kCookieLength) {
        stationHandshakes->handleCookie(now, from, datagram);
        return; // no timer has changed
    } else if (message == HandshakeMessage::Cookie && stationHandshakes && datagram.size() == kNumberLength) {
        if (!stationHandshakes->handleNumber(now, from, datagram))
            return;
    } else if (message == HandshakeMessage::Announcement && stationHandshakes) {
        if (!stationHandshakes->handleAnnouncement(now, from, datagram))
            return;
    } else {
        ++core.unmatched.malformed;
        return;
    }
    handleDeadline(now);
}

Endpoint::Endpoint(Config config, RandomSource &random, CounterStore &counters, TimePoint now)
    : m_state(std::make_unique<State>(std::move(config), random, counters, now))
{}

Endpoint::~Endpoint() = default;
Endpoint::Endpoint(Endpoint &&) noexcept = default;
Endpoint &Endpoint::operator=(Endpoint &&) noexcept = default;

// ---- query

std::vector<SessionId> Endpoint::sessions() const
{
    std::vector<SessionId> out;
    m_state->core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up)
            out.push_back(entry.session->id());
    });
    return out;
}

std::optional<SessionInfo> Endpoint::sessionInfo(SessionId session) const
{
    const auto *entry = m_state->core.table.find(session);
    if (!entry || !entry->up)
        return std::nullopt;
    return entry->session->info(m_state->now);
}

std::optional<SessionStats> Endpoint::stats(SessionId session) const
{
    const auto *entry = m_state->core.table.find(session);
    if (!entry || !entry->up)
        return std::nullopt;
    return entry->session->stats();
}

std::vector<Unanswered> Endpoint::unanswered() const
{
    return m_state->stationHandshakes ? m_state->stationHandshakes->unanswered() : std::vector<Unanswered>();
}

std::optional<TimePoint> Endpoint::lastCall(const Path &place) const
{
    return m_state->stationHandshakes ? m_state->stationHandshakes->lastCall(place) : std::nullopt;
}

bool Endpoint::namesSerialSession(ByteView message) const
{
    const auto header = RecordHeader::read(message);
    if (!header || header->kind != DatagramKind::Record)
        return false;
    const auto *entry = m_state->core.table.find(header->connection);
    return entry && entry->up && entry->session->path().carrier == Carrier::Serial;
}

const ReceiveCounters &Endpoint::unmatched() const
{
    return m_state->core.unmatched;
}

std::uint64_t Endpoint::strangerHashes() const
{
    return m_state->core.strangerHashes;
}

TimePoint Endpoint::nextDeadline() const
{
    return m_state->deadline;
}

bool Endpoint::owns(std::uint8_t firstByte)
{
    return isOurs(firstByte);
}

bool Endpoint::ownsFrame(ByteView frame)
{
    return looksInline(frame);
}

std::size_t Endpoint::stampLength() const
{
    return m_state->stationHandshakes ? kFrameStampLength : 0;
}

bool Endpoint::isAnnouncement(ByteView datagram)
{
    return Announcement::hasForm(datagram);
}

// ---- input

std::optional<Delivery> Endpoint::handleDatagram(TimePoint now, const Path &from, MutableByteView datagram)
{
    if (datagram.empty() || !isOurs(datagram[0])) {
        ++m_state->core.unmatched.malformed;
        return std::nullopt;
    }
    if (versionOf(datagram[0]) != kProtocolVersion) {
        ++m_state->core.unmatched.malformed;
        m_state->core.notifyRefused(now, from, RefusalReason::Version);
        return std::nullopt;
    }
    if (kindOf(datagram[0]) == DatagramKind::Record || kindOf(datagram[0]) == DatagramKind::SingleRecord)
        return m_state->handleRecord(now, from, datagram);
    if (kindOf(datagram[0]) == DatagramKind::Handshake)
        m_state->handleHandshake(now, from, datagram);
    else
        ++m_state->core.unmatched.malformed;
    return std::nullopt;
}

void Endpoint::handleDeadline(TimePoint now)
{
    m_state->handleDeadline(now);
}

std::optional<Delivery> Endpoint::handleInlineFrame(TimePoint now, const Path &from, MutableByteView frame)
{
    return m_state->handleInlineFrame(now, from, frame);
}

void Endpoint::handleStreamBegan(TimePoint now, LinkId link)
{
    m_state->core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up && entry.session->path().link == link)
            entry.session->requestReport(now);
    });
    m_state->refresh(now);
}

void Endpoint::countPlaintextDropped(SessionId session, std::uint64_t count)
{
    if (auto *entry = m_state->core.table.find(session))
        entry->session->countPlaintextDropped(count);
    else
        m_state->core.unmatched.plaintextDropped += count;
}

void Endpoint::noteFrames(SessionId session, const FrameCounters &frames)
{
    if (auto *entry = m_state->core.table.find(session))
        entry->session->noteFrames(frames);
}

void Endpoint::setCostSource(CostSource source)
{
    m_state->core.context.costs = std::move(source);
}

// ---- command

void Endpoint::askCosts(bool ask)
{
    if (std::exchange(m_state->core.context.askCosts, ask) != ask)
        m_state->deadline = m_state->now; // each session reports the change
}

Sealed Endpoint::seal(TimePoint now, SessionId session, ByteView frames, MutableByteView out)
{
    auto *entry = m_state->core.table.find(session);
    if (!entry || !entry->up)
        return SealError::NoSession;
    const auto sealed = entry->session->seal(now, frames, out);
    if (!sealed && sealed.error() == SealError::Exhausted)
        m_state->handleDeadline(now);
    return sealed;
}

Sealed Endpoint::sealInline(TimePoint now, SessionId session, ByteView frame, MutableByteView out)
{
    auto *entry = m_state->core.table.find(session);
    if (!entry || !entry->up)
        return SealError::NoSession;
    const auto sealed = entry->session->sealInline(now, frame, out);
    if (!sealed && sealed.error() == SealError::Exhausted)
        m_state->handleDeadline(now);
    return sealed;
}

Framing Endpoint::framing(SessionId session) const
{
    const auto *entry = m_state->core.table.find(session);
    return entry ? entry->session->framing() : Framing::Sealed;
}

Path Endpoint::recordPath(SessionId session) const
{
    const auto *entry = m_state->core.table.find(session);
    return entry ? entry->session->path() : Path{};
}

void Endpoint::switchSuite(TimePoint now, SessionId session, crypto::SuiteId suite)
{
    if (auto *entry = m_state->core.table.find(session); entry && entry->up)
        entry->session->switchSuite(now, suite);
    m_state->refresh(now);
}

void Endpoint::rekey(TimePoint now, SessionId session)
{
    if (auto *entry = m_state->core.table.find(session); entry && entry->up)
        entry->session->rekey(now);
    m_state->refresh(now);
}

void Endpoint::close(TimePoint now, SessionId session)
{
    if (auto *entry = m_state->core.table.find(session); entry && entry->up)
        m_state->core.end(now, *entry->session, DownReason::Closed);
    m_state->refresh(now);
}

void Endpoint::setPeers(TimePoint now, std::vector<Peer> peers)
{
    State &state = *m_state;
    state.core.config.peers = std::move(peers);
    state.core.table.forEach([&](SessionTable::Entry &entry) {
        const Peer *peer = state.core.peer(entry.session->peer().key);
        if (peer && samePresharedKey(peer->presharedKey, entry.session->peer().presharedKey))
            entry.session->updatePeer(*peer);
        else if (entry.up)
            state.core.end(now, *entry.session, peer ? DownReason::Closed : DownReason::Revoked);
    });
    if (state.stationHandshakes)
        state.stationHandshakes->peersChanged();
    else
        state.agentHandshakes->peersChanged();
    state.refresh(now);
}

void Endpoint::setPolicy(TimePoint now, Policy policy)
{
    State &state = *m_state;
    state.core.config.policy = std::move(policy);
    state.core.updateOffer();
    state.core.table.forEach([&](SessionTable::Entry &entry) {
        if (entry.up)
            entry.session->policyChanged(now);
    });
    if (state.stationHandshakes)
        state.stationHandshakes->policyChanged();
    state.refresh(now);
}

void Endpoint::setAnnounceTo(TimePoint now, std::vector<Path> paths)
{
    m_state->core.config.announceTo = std::move(paths);
    m_state->refresh(now);
}

void Endpoint::setCallAt(TimePoint now, std::vector<Path> paths)
{
    if (m_state->core.config.callAt == paths)
        return;
    if (m_state->stationHandshakes)
        m_state->stationHandshakes->setCallAt(std::move(paths));
    m_state->handleDeadline(now);
}

// ---- output

std::optional<Transmit> Endpoint::pollTransmit()
{
    const DatagramQueue::Item *item = m_state->core.context.outgoing.pop();
    if (!item)
        return std::nullopt;
    return Transmit{item->to, item->view()};
}

bool Endpoint::hasTransmit() const
{
    return !m_state->core.context.outgoing.empty();
}

std::optional<Event> Endpoint::pollEvent()
{
    auto &events = m_state->core.context.events;
    if (events.empty())
        return std::nullopt;
    Event event = std::move(events.front());
    events.pop_front();
    return event;
}

} // namespace skyseal::channel
