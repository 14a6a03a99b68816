#include "core/channel/pairing_station.h"

#include "core/crypto/x25519.h"

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kRequestEvery = std::chrono::milliseconds(500);
constexpr std::size_t kMaxCallers = 16;
constexpr Duration kHeardOfLate = std::chrono::seconds(3);
/// Time-out for an answer. Afterwards the next caller has its turn, which may be the same one.
constexpr Duration kAttempt = std::chrono::seconds(3);
constexpr Duration kFirstPause = std::chrono::milliseconds(50);
constexpr Duration kPauseAfterBadAnswer = std::chrono::milliseconds(250);
/// Time-out for the agent's opening. There is no second attempt in this window.
constexpr Duration kContinued = std::chrono::seconds(10);
constexpr Duration kOpeningRepeat = std::chrono::milliseconds(250);
constexpr unsigned kSlowest = 2; ///< the pause is doubled so often
/// A correct opening is answered within this many copies, except over a very bad link.
constexpr unsigned kOpeningsBeforeHint = 5;

} // namespace

void PairingStation::request(TimePoint now)
{
    if (now < requestDue())
        return;
    for (const Path &path : m_core.config.callTo)
        m_core.outgoing.push(path, pairingRequest());
    m_requestDue = now + m_core.jittered(kRequestEvery);
}

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
    if (m_attempt->path == from && !m_attempt->opened && now >= m_attempt->sentAt + kFirstPause) {
        m_attempt->sentAt = now;
        m_core.outgoing.push(from, m_attempt->handshake.first());
    }
}

/// Tries this caller, unless another one has waited longer; then that one is tried at its next call.
void PairingStation::begin(TimePoint now)
{
    Caller *next = nullptr;
    for (Caller &caller : m_callers) {
        if (now < caller.heard + kHeardOfLate && (!next || caller.tried < next->tried))
            next = &caller;
    }
    if (!next || next->heard != now)
        return;
    next->tried = now;
    std::array<std::uint8_t, 4> id;
    m_core.random.fill(id);
    const PairingId pairing{static_cast<std::uint32_t>(id[0] | id[1] << 8 | id[2] << 16)
                            | static_cast<std::uint32_t>(id[3]) << 24};
    m_attempt.emplace(Attempt{PairingHandshake::begin(m_core.config, pairing, next->token, next->path.carrier, m_core.random),
                              next->path, now + kAttempt, now});
    m_core.outgoing.push(next->path, m_attempt->handshake.first());
}

void PairingStation::handleAnswer(TimePoint now, const Path &from, ByteView datagram)
{
    if (!m_attempt || m_attempt->opened || m_attempt->path != from)
        return;
    const auto answer = readAnswer(datagram);
    if (!answer || answer->id != m_attempt->handshake.id())
        return;
    if (!m_attempt->handshake.takeAnswer(datagram)) {
        m_attempt.reset(); // An eavesdropper knows the id. The next call starts an attempt with another one.
        m_nextFrom = now + kPauseAfterBadAnswer;
        return;
    }
    m_attempt->opened = true;
    m_attempt->until = now + kContinued;
    sendOpening(now);
}

void PairingStation::sendOpening(TimePoint now)
{
    Attempt &attempt = *m_attempt;
    m_core.outgoing.push(attempt.path, attempt.handshake.opening());
    attempt.openingDue = now + m_core.jittered(kOpeningRepeat * (1 << std::min(attempt.openingsSent, kSlowest)));
    if (++attempt.openingsSent == kOpeningsBeforeHint)
        m_core.hintAtPassphrase(now);
}

/// Called after our opening was sent: its receiver may know the code, and must not have a second attempt.
void PairingStation::giveUp()
{
    m_attempt.reset();
    m_core.failure = PairingEnd::Interrupted;
}

std::optional<PairingConfirmation> PairingStation::handleOpening(TimePoint now, const Path &from, ByteView datagram)
{
    if (!m_attempt || !m_attempt->opened || m_attempt->path != from)
        return std::nullopt;
    const auto opening = m_attempt->handshake.takeOpening(datagram);
    if (!opening && opening.error() == OpeningError::Unreadable)
        return std::nullopt;
    if (!opening || opening->key == m_core.config.identity->publicKey) {
        giveUp();
        return std::nullopt;
    }
    PairingPeer peer{opening->key, opening->name, opening->systemId, m_attempt->handshake.code(), from};
    auto words = m_attempt->handshake.finish();
    m_attempt.reset();
    if (!words) {
        giveUp();
        return std::nullopt;
    }
    return PairingConfirmation(std::move(peer), std::move(*words), now);
}

void PairingStation::handleDeadline(TimePoint now)
{
    std::erase_if(m_callers, [now](const Caller &caller) { return now >= caller.heard + kHeardOfLate; });
    if (!m_attempt)
        return;
    if (now >= m_attempt->until) {
        if (m_attempt->opened)
            giveUp();
        else
            m_attempt.reset(); // The next call starts another attempt.
    } else if (now >= m_attempt->openingDue) {
        sendOpening(now);
    }
}

TimePoint PairingStation::deadline() const
{
    return m_attempt ? std::min(m_attempt->until, m_attempt->openingDue) : kNever;
}

} // namespace skyseal::channel
