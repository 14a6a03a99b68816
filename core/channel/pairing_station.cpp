#include "core/channel/pairing_station.h"

#include "core/base/weakness.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr std::size_t kMaxCallers = 16;
constexpr Duration kHeardOfLate = std::chrono::seconds(3);
/// Time-out for an answer, and then for a word. Afterwards the next caller has its turn, which may be the same one.
constexpr Duration kAttempt = std::chrono::seconds(3);
constexpr Duration kFirstPause = std::chrono::milliseconds(50);
constexpr Duration kThirdRepeat = std::chrono::milliseconds(250);
/// An eavesdropper can send false answers to the first message, one Diffie-Hellman computation each. When no more may be
/// computed on, the true one would not be read either: the next call starts again, with a new id.
constexpr double kAnswersPerSecond = 50;
constexpr double kAnswersAtOnce = 20;
constexpr Duration kPauseAfterFlood = std::chrono::milliseconds(250);

} // namespace

void PairingStation::handleCall(TimePoint now, const Path &from, ByteView datagram)
{
    const auto token = calledToken(datagram);
    if (!token)
        return;
    auto caller = std::find_if(m_callers.begin(), m_callers.end(),
                               [&](const Caller &c) { return c.path == from && c.token == *token; });
    if (caller == m_callers.end()) {
        if (m_callers.size() == kMaxCallers)
            m_callers.erase(std::min_element(m_callers.begin(), m_callers.end(),
                                             [](const Caller &a, const Caller &b) { return a.heard < b.heard; }));
        m_callers.push_back({from, *token});
        caller = m_callers.end() - 1;
    }
    caller->heard = now;
    if (!m_attempt) {
        if (now >= m_nextFrom)
            begin(now);
        return;
    }
    // One first message for one call, so that a forged source address yields no amplification.
    const bool answered = m_attempt->voice.has_value();
    if (m_attempt->path == from && !answered && now >= m_attempt->sentAt + kFirstPause) {
        m_attempt->sentAt = now;
        m_core.outgoing.push(from, m_attempt->first);
    }
}

/// Takes up this caller, unless another one has waited longer; then that one, at its next call.
void PairingStation::begin(TimePoint now)
{
    Caller *next = nullptr;
    for (Caller &caller : m_callers) {
        if (!caller.aside && now < caller.heard + kHeardOfLate && (!next || caller.tried < next->tried))
            next = &caller;
    }
    if (!next || next->heard != now)
        return;
    next->tried = now;
    std::array<std::uint8_t, 4> id;
    m_core.random.fill(id);
    auto handshake = PairingHandshake::begin(
        noise::Role::Initiator, *m_core.config.identity, m_core.config.passphraseKey.get(),
        PairingId{static_cast<std::uint32_t>(id[0] | id[1] << 8 | id[2] << 16) | static_cast<std::uint32_t>(id[3]) << 24},
        next->token, next->path.carrier);
    const auto first = handshake ? handshake->first(m_core.random) : std::nullopt;
    if (!first)
        return;
    m_attempt.emplace(Attempt{std::move(*handshake), next->path, *first, now + kAttempt, now});
    m_core.outgoing.push(next->path, *first);
}

void PairingStation::handleAnswer(TimePoint now, const Path &from, ByteView datagram)
{
    if (!m_attempt || m_attempt->voice || m_attempt->path != from || answeredPairing(datagram) != m_attempt->handshake.id())
        return;
    if (!m_answers.take(now, kAnswersPerSecond, kAnswersAtOnce) && !weakened(Weakness::NoRateLimit)) {
        m_attempt.reset();
        m_nextFrom = now + kPauseAfterFlood;
        return;
    }
    const auto about = m_attempt->handshake.readAnswer(datagram);
    if (!about)
        return;
    const PublicKey key = m_attempt->handshake.peer();
    const auto third = m_attempt->handshake.third(m_core.about(), m_core.random);
    if (!third || !m_core.mayShow(key)) {
        setAside(from);
        m_attempt.reset();
        return;
    }
    if (about->hasPassphrase != (m_core.config.passphraseKey != nullptr))
        m_core.hintAtPassphrase(now);
    m_attempt->voice = std::move(m_attempt->handshake).finish();
    if (!m_attempt->voice) {
        m_attempt.reset();
        return;
    }
    // A station asks for its own role; the role of an agent is fixed.
    m_attempt->peer = {key, about->name, about->roleAsked, from};
    m_attempt->presharedKeyWanted = about->wantPresharedKey && m_core.config.wantPresharedKey;
    m_attempt->third = *third;
    m_attempt->until = now + kAttempt;
    sendThird(now);
}

void PairingStation::sendThird(TimePoint now)
{
    Attempt &attempt = *m_attempt;
    m_core.outgoing.push(attempt.path, attempt.third);
    attempt.due = now + m_core.jittered(kThirdRepeat * (1 << std::min(attempt.sent++, 3u)));
}

std::optional<PairingConfirmation> PairingStation::handleWord(TimePoint now, const Path &from, ByteView datagram)
{
    if (!m_attempt || !m_attempt->voice || m_attempt->path != from || !m_attempt->voice->hear(datagram))
        return std::nullopt;
    PairingConfirmation talk(m_attempt->peer, std::move(*m_attempt->voice), m_attempt->presharedKeyWanted, now);
    m_attempt.reset();
    talk.hear(now, from, datagram);
    return talk;
}

void PairingStation::setAside(const Path &path)
{
    for (Caller &caller : m_callers)
        caller.aside = caller.aside || caller.path == path;
}

void PairingStation::handleDeadline(TimePoint now)
{
    std::erase_if(m_callers, [now](const Caller &caller) { return !caller.aside && now >= caller.heard + kHeardOfLate; });
    if (!m_attempt)
        return;
    if (now >= m_attempt->until) {
        if (m_attempt->voice && m_core.config.passphraseKey)
            m_core.hintAtPassphrase(now); // It answers, but not to the message that needs the passphrase.
        m_attempt.reset();                // The next call starts another attempt.
    } else if (now >= m_attempt->due) {
        sendThird(now);
    }
}

TimePoint PairingStation::deadline() const
{
    return m_attempt ? std::min(m_attempt->until, m_attempt->due) : kNever;
}

} // namespace skyseal::channel
