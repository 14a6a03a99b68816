#include "core/channel/pairing_agent.h"

#include "core/crypto/x25519.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kCallEvery = std::chrono::milliseconds(500);
constexpr std::size_t kMaxAnswered = 8;
/// Three scalar multiplications each, and the derivation of a generator.
constexpr double kFirstsPerSecond = 15;
constexpr Duration kPairingAnswerKept = std::chrono::seconds(10);
constexpr unsigned kMaxWrongPassphrases = 3;

} // namespace

PairingAgent::PairingAgent(PairingCore &core, TimePoint now)
    : m_core(core), m_limit(core.random, now, kFirstsPerSecond), m_callDue(now)
{
    m_core.random.fill(m_token);
}

void PairingAgent::call(TimePoint now)
{
    if (now < m_callDue || m_core.config.callTo.empty())
        return;
    const PairingDatagram datagram = pairingCall(m_token);
    for (const Path &path : m_core.config.callTo)
        m_core.outgoing.push(path, datagram);
    m_callDue = now + m_core.jittered(kCallEvery);
}

void PairingAgent::handleRequest(const Path &from)
{
    if (!hasOpened() && std::ranges::find(m_core.config.listensOn, from.link) != m_core.config.listensOn.end())
        m_core.outgoing.push(from, pairingCall(m_token));
}

bool PairingAgent::mayCompute(TimePoint now, const Path &from)
{
    const auto &called = m_core.config.callTo;
    const bool expected = std::any_of(called.begin(), called.end(), [&from](const Path &path) {
        return path.link == from.link && path.remote.ip == from.remote.ip;
    });
    return m_limit.admit(now, from, expected ? Standing::Expected : Standing::Proven);
}

void PairingAgent::forgetOldAnswers(TimePoint now)
{
    std::erase_if(m_answered, [now](const Answered &answered) { return now >= answered.at + kPairingAnswerKept; });
}

void PairingAgent::handleFirst(TimePoint now, const Path &from, ByteView datagram)
{
    // A sender that has not received a call of this window costs no more than a comparison.
    const auto hello = readFirst(datagram);
    if (!hello || sodium_memcmp(hello->token.data(), m_token.data(), m_token.size()) != 0)
        return;
    if (hasOpened()) {
        if (from != m_opened->path || !std::ranges::equal(datagram, m_opened->first))
            m_core.reportOther(now);
        return;
    }
    forgetOldAnswers(now);
    for (const Answered &answered : m_answered) {
        if (answered.path == from && std::ranges::equal(datagram, answered.handshake.first())) {
            m_core.outgoing.push(from, answered.handshake.answer());
            return;
        }
    }
    if (!mayCompute(now, from))
        return;
    auto handshake = PairingHandshake::begin(m_core.config, hello->id, hello->token, from.carrier, m_core.random);
    if (!handshake.takeFirst(datagram))
        return;
    if (m_answered.size() == kMaxAnswered)
        m_answered.erase(m_answered.begin());
    m_core.outgoing.push(from, handshake.answer());
    m_answered.push_back({std::move(handshake), from, now});
}

/// A guess may leave no other trace than this one.
void PairingAgent::noteWrongOpening(TimePoint now, Answered &answered)
{
    if (answered.failed)
        return;
    answered.failed = true;
    m_core.hintAtPassphrase(now);
    if (m_core.config.passphrase && ++m_wrongPassphrases == kMaxWrongPassphrases)
        m_core.failure = PairingEnd::Guessed;
}

std::optional<PairingConfirmation> PairingAgent::handleOpening(TimePoint now, const Path &from, ByteView datagram)
{
    if (m_opened && m_opened->path == from && std::ranges::equal(datagram, m_opened->theirs)) {
        m_core.outgoing.push(from, m_opened->ours); // The station repeats its opening: ours was lost.
        return std::nullopt;
    }
    if (hasOpened())
        return std::nullopt;
    forgetOldAnswers(now);
    const auto found = std::find_if(m_answered.begin(), m_answered.end(), [&](const Answered &answered) {
        return answered.path == from && answered.handshake.id() == sealedPairing(datagram);
    });
    if (found == m_answered.end())
        return std::nullopt;
    const PairingHandshake &handshake = found->handshake;
    const auto opening = found->handshake.takeOpening(datagram);
    // A correct passphrase with a key that cannot be shown counts like a wrong one: a difference would confirm a guess.
    const bool isShowable = opening && opening->key != m_core.config.identity->publicKey;
    auto words = isShowable ? handshake.finish() : std::nullopt;
    if (!words) {
        noteWrongOpening(now, *found);
        return std::nullopt;
    }
    PairingPeer peer{opening->key, opening->name, opening->systemId, handshake.code(), from};
    m_opened = Opened{from, handshake.first(), {}, handshake.opening()};
    std::ranges::copy(datagram, m_opened->theirs.begin());
    m_core.outgoing.push(from, m_opened->ours);
    m_answered.clear();
    return PairingConfirmation(std::move(peer), std::move(*words), now);
}

bool PairingAgent::hasOpened() const
{
    return m_opened.has_value();
}

} // namespace skyseal::channel
