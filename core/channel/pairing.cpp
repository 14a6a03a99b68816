#include "core/channel/pairing.h"

#include "core/base/locked_memory.h"
#include "core/channel/pairing_agent.h"
#include "core/channel/pairing_station.h"

namespace skyseal::channel {

namespace {

constexpr int kRefusals = 3;
constexpr Duration kRefusalEvery = std::chrono::milliseconds(250);

} // namespace

struct Pairing::State : InLockedMemory
{
    State(PairingConfig configuration, RandomSource &random, TimePoint start)
        : core{std::move(configuration), random}, closesAt(start + core.config.window)
    {
        if (core.config.role == Role::Agent)
            agent.emplace(core, start);
        else
            station.emplace(core);
    }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    void takeUp(std::optional<PairingConfirmation> &&next);
    void handleWord(TimePoint at, const Path &from, ByteView datagram);
    void judge(TimePoint at);
    void close(TimePoint at, PairingEnd reason);
    void handleDeadline(TimePoint at);
    void sendRefusal(TimePoint at);
    TimePoint deadline() const;

    /// Repetitions of a refusal after the confirmation has ended.
    struct Refusal
    {
        Path path;
        WordDatagram word{};
        int left = kRefusals;
        TimePoint due{};
    };

    PairingCore core;
    TimePoint closesAt;
    std::optional<PairingAgent> agent;
    std::optional<PairingStation> station;
    std::optional<PairingConfirmation> talk;
    std::optional<Refusal> refusal;
    std::optional<PairingEnd> over;
};

/// A handshake has finished. The peer is shown after its first word.
void Pairing::State::takeUp(std::optional<PairingConfirmation> &&next)
{
    if (next && !talk)
        talk = std::move(next);
}

void Pairing::State::handleWord(TimePoint at, const Path &from, ByteView datagram)
{
    if (!talk)
        return;
    const bool wasShown = talk->isShown();
    const Decision before = talk->theirs();
    if (!talk->receive(at, from, datagram))
        return;
    if (!wasShown)
        core.events.push_back(PairingPeerSeen{talk->peer()});
    if (talk->theirs() != before)
        judge(at);
}

/// After either person decided.
void Pairing::State::judge(TimePoint at)
{
    if (talk->theirs() == Decision::No) {
        close(at, PairingEnd::RefusedThere);
    } else if (talk->paired()) {
        core.events.push_back(Paired{talk->pairedPeer()});
        close(at, PairingEnd::Paired);
    } else if (talk->theirs() == Decision::Yes) {
        core.events.push_back(PairingPeerConfirmed{talk->peer().key});
    }
}

void Pairing::State::close(TimePoint at, PairingEnd reason)
{
    if (over)
        return;
    over = reason;
    core.events.push_back(PairingOver{reason});
    if (!talk || reason == PairingEnd::Paired)
        return;
    if (reason != PairingEnd::RefusedThere) {
        talk->decide(at, Decision::No);
        refusal = Refusal{talk->peer().path, talk->word(), kRefusals, at};
    }
    talk.reset();
}

void Pairing::State::sendRefusal(TimePoint at)
{
    if (!refusal || at < refusal->due)
        return;
    core.outgoing.push(refusal->path, refusal->word);
    refusal->due = at + core.jittered(kRefusalEvery);
    if (--refusal->left == 0)
        refusal.reset();
}

void Pairing::State::handleDeadline(TimePoint at)
{
    if (!over && at >= closesAt)
        close(at, PairingEnd::TimedOut);
    if (talk && talk->silent(at))
        core.failure = PairingEnd::Interrupted;
    if (!over && !talk && station)
        station->handleDeadline(at);
    if (core.failure)
        close(at, *core.failure);
    if (talk)
        talk->handleDeadline(at, core);
    if (talk && talk->settled(at))
        talk.reset();
    if (!over && !talk && agent)
        agent->call(at);
    if (!over && !talk && station)
        station->request(at);
    sendRefusal(at);
}

TimePoint Pairing::State::deadline() const
{
    TimePoint due = over ? kNever : closesAt;
    if (talk)
        due = std::min(due, talk->deadline());
    if (!over && !talk && agent)
        due = std::min(due, agent->callDue());
    if (!over && !talk && station)
        due = std::min({due, station->deadline(), station->requestDue()});
    if (refusal)
        due = std::min(due, refusal->due);
    return due;
}

Pairing::Pairing(PairingConfig config, RandomSource &random, TimePoint now)
    : m_state(std::make_unique<State>(std::move(config), random, now))
{}

Pairing::~Pairing() = default;
Pairing::Pairing(Pairing &&) noexcept = default;
Pairing &Pairing::operator=(Pairing &&) noexcept = default;

// ---- query

bool Pairing::owns(std::uint8_t first)
{
    return isOurs(first) && versionOf(first) == kProtocolVersion && kindOf(first) == DatagramKind::Pairing;
}

const PairingPeer *Pairing::peer() const
{
    return m_state->talk && m_state->talk->isShown() ? &m_state->talk->peer() : nullptr;
}

bool Pairing::confirmedHere() const
{
    return m_state->talk && m_state->talk->mine() == Decision::Yes;
}

bool Pairing::confirmedThere() const
{
    return m_state->talk && m_state->talk->theirs() == Decision::Yes;
}

bool Pairing::finished() const
{
    return m_state->over && !m_state->talk && !m_state->refusal;
}

TimePoint Pairing::nextDeadline() const
{
    return m_state->deadline();
}

// ---- input

void Pairing::handleDatagram(TimePoint now, const Path &from, ByteView datagram)
{
    State &state = *m_state;
    if (datagram.empty() || !owns(datagram[0]))
        return;
    const auto message = static_cast<PairingMessage>(datagram[0] & 3);
    if (isWord(datagram)) {
        state.handleWord(now, from, datagram);
    } else if (state.over) {
        return;
    } else if (state.agent && !state.talk && isPairingRequest(datagram)) {
        state.agent->handleRequest(from);
    } else if (state.agent && message == PairingMessage::First) {
        state.agent->handleFirst(now, from, datagram);
    } else if (state.agent && isOpening(datagram)) {
        state.takeUp(state.agent->handleOpening(now, from, datagram));
    } else if (state.station && !state.talk && message == PairingMessage::Call) {
        state.station->handleCall(now, from, datagram);
    } else if (state.station && !state.talk && message == PairingMessage::Answer) {
        state.station->handleAnswer(now, from, datagram);
    } else if (state.station && !state.talk && isOpening(datagram)) {
        state.takeUp(state.station->handleOpening(now, from, datagram));
    }
    state.handleDeadline(now);
}

void Pairing::handleDeadline(TimePoint now)
{
    m_state->handleDeadline(now);
}

// ---- command

void Pairing::setCallTo(std::vector<Path> paths)
{
    m_state->core.config.callTo = std::move(paths);
}

void Pairing::confirm(TimePoint now, const PublicKey &key)
{
    State &state = *m_state;
    if (state.over || !peer() || peer()->key != key || state.talk->mine() != Decision::None)
        return;
    state.talk->decide(now, Decision::Yes);
    if (state.talk->paired())
        state.judge(now);
    state.handleDeadline(now);
}

void Pairing::refuse(TimePoint now)
{
    if (!peer())
        return;
    m_state->close(now, PairingEnd::Refused);
    m_state->handleDeadline(now);
}

void Pairing::cancel(TimePoint now, PairingEnd reason)
{
    m_state->close(now, reason);
    m_state->handleDeadline(now);
}

// ---- output

std::optional<Transmit> Pairing::pollTransmit()
{
    const DatagramQueue::Item *item = m_state->core.outgoing.pop();
    if (!item)
        return std::nullopt;
    return Transmit{item->to, item->view()};
}

std::optional<PairingEvent> Pairing::pollEvent()
{
    auto &events = m_state->core.events;
    if (events.empty())
        return std::nullopt;
    PairingEvent event = std::move(events.front());
    events.pop_front();
    return event;
}

} // namespace skyseal::channel
