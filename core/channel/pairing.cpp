#include "core/channel/pairing.h"

#include "core/base/weakness.h"
#include "core/channel/pairing_agent.h"
#include "core/channel/pairing_station.h"

namespace skyseal::channel {

namespace {

constexpr int kFarewells = 3;
constexpr Duration kFarewellEvery = std::chrono::milliseconds(250);
constexpr std::size_t kMaxFarewells = 4;

} // namespace

struct Pairing::State
{
    State(PairingConfig configuration, RandomSource &random, TimePoint start)
        : core{std::move(configuration), random, {}, {}, {}}, closesAt(start + core.config.window), now(start)
    {
        if (core.config.role == Role::Agent)
            agent.emplace(core, start);
        else
            station.emplace(core);
    }
    State(const State &) = delete;
    State &operator=(const State &) = delete;

    void takeUp(TimePoint at, std::optional<PairingConfirmation> &&next);
    void handleWord(TimePoint at, const Path &from, ByteView datagram);
    void weigh(TimePoint at);
    void dropTalk(PairingGone reason);
    void turnDown(TimePoint at);
    void sayNo(TimePoint at);
    void close(TimePoint at, PairingEnd reason);
    void handleDeadline(TimePoint at);
    TimePoint deadline() const;

    /// Repetitions of a refusal after the confirmation has ended.
    struct Farewell
    {
        Path path;
        WordDatagram word{};
        int left = kFarewells;
        TimePoint due{};
    };

    PairingCore core;
    TimePoint closesAt;
    TimePoint now; ///< of the last input or command
    std::optional<PairingAgent> agent;
    std::optional<PairingStation> station;
    std::optional<PairingConfirmation> talk;
    std::vector<Farewell> farewells;
    std::optional<PairingEnd> over;
    TimePoint otherTold = TimePoint::min();
};

/// A handshake has finished. Only the first peer is shown, so that nobody can replace the key that a person is comparing.
void Pairing::State::takeUp(TimePoint at, std::optional<PairingConfirmation> &&next)
{
    if (!next)
        return;
    if (talk && talk->peer().key != next->peer().key && !weakened(Weakness::ShowNewest)) {
        if (at >= otherTold) {
            core.events.push_back(PairingOtherTried{next->peer()});
            otherTold = at + std::chrono::seconds(1);
        }
        return;
    }
    if (talk)
        dropTalk(PairingGone::Replaced);
    talk = std::move(next);
    core.events.push_back(PairingPeerSeen{talk->peer()});
    weigh(at);
}

void Pairing::State::handleWord(TimePoint at, const Path &from, ByteView datagram)
{
    if (!talk) {
        if (station && !over)
            takeUp(at, station->handleWord(at, from, datagram));
        return;
    }
    const Decision before = talk->theirs();
    if (talk->hear(at, from, datagram) && talk->theirs() != before)
        weigh(at);
}

/// After either person decided.
void Pairing::State::weigh(TimePoint at)
{
    if (talk->theirs() == Decision::No) {
        core.turnedDown.push_back(talk->peer().key); // Neither person is asked again about it in this window.
        if (station)
            station->setAside(talk->peer().path);
        dropTalk(PairingGone::Refused);
    } else if (talk->paired()) {
        core.events.push_back(Paired{talk->pairedPeer()});
        close(at, PairingEnd::Paired);
    } else if (talk->theirs() == Decision::Yes) {
        core.events.push_back(PairingPeerConfirmed{talk->peer().key});
    }
}

void Pairing::State::dropTalk(PairingGone reason)
{
    core.events.push_back(PairingPeerGone{talk->peer().key, reason});
    talk.reset();
}

void Pairing::State::sayNo(TimePoint at)
{
    talk->decide(at, Decision::No);
    if (farewells.size() == kMaxFarewells)
        farewells.erase(farewells.begin());
    farewells.push_back({talk->peer().path, talk->word(), kFarewells, at});
    talk.reset();
}

void Pairing::State::turnDown(TimePoint at)
{
    core.turnedDown.push_back(talk->peer().key);
    if (station)
        station->setAside(talk->peer().path);
    sayNo(at);
}

void Pairing::State::close(TimePoint at, PairingEnd reason)
{
    if (over)
        return;
    over = reason;
    core.events.push_back(PairingOver{reason});
    if (talk && reason != PairingEnd::Paired)
        sayNo(at);
}

void Pairing::State::handleDeadline(TimePoint at)
{
    now = at;
    if (!over && at >= closesAt)
        close(at, PairingEnd::TimedOut);
    if (talk && talk->silent(at))
        dropTalk(PairingGone::Silent);
    if (talk)
        talk->handleDeadline(at, core);
    if (talk && talk->settled(at))
        talk.reset();
    if (!over && !talk && agent)
        agent->call(at);
    if (!over && !talk && station)
        station->handleDeadline(at);
    for (Farewell &farewell : farewells) {
        if (at < farewell.due)
            continue;
        core.outgoing.push(farewell.path, farewell.word);
        --farewell.left;
        farewell.due = at + core.jittered(kFarewellEvery);
    }
    std::erase_if(farewells, [](const Farewell &farewell) { return farewell.left == 0; });
}

TimePoint Pairing::State::deadline() const
{
    TimePoint due = over ? kNever : closesAt;
    if (talk)
        due = std::min(due, talk->deadline());
    if (!over && !talk && agent)
        due = std::min(due, agent->callDue());
    if (!over && !talk && station)
        due = std::min(due, station->deadline());
    for (const Farewell &farewell : farewells)
        due = std::min(due, farewell.due);
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
    return m_state->talk ? &m_state->talk->peer() : nullptr;
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
    return m_state->over && !m_state->talk && m_state->farewells.empty();
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
    } else if (state.agent && message == PairingMessage::First) {
        state.agent->handleFirst(now, from, datagram);
    } else if (state.agent && isThird(datagram)) {
        if (state.talk && state.talk->isOf(from, sealedPairing(datagram)))
            state.talk->repeat(now);
        else
            state.takeUp(now, state.agent->handleThird(now, from, datagram));
    } else if (state.station && !state.talk && message == PairingMessage::Call) {
        state.station->handleCall(now, from, datagram);
    } else if (state.station && !state.talk && message == PairingMessage::Answer) {
        state.station->handleAnswer(now, from, datagram);
    }
    state.handleDeadline(now);
}

void Pairing::handleDeadline(TimePoint now)
{
    m_state->handleDeadline(now);
}

// ---- command

void Pairing::confirm(TimePoint now, const PublicKey &key)
{
    State &state = *m_state;
    if (state.over || !state.talk || state.talk->peer().key != key || state.talk->mine() != Decision::None)
        return;
    state.talk->decide(now, Decision::Yes);
    if (state.talk->paired())
        state.weigh(now);
    state.handleDeadline(now);
}

void Pairing::refuse(TimePoint now)
{
    if (m_state->over || !m_state->talk)
        return;
    m_state->turnDown(now);
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
