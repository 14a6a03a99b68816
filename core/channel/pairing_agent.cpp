#include "core/channel/pairing_agent.h"

#include <sodium.h>

#include <algorithm>

namespace skyseal::channel {

namespace {

constexpr Duration kCallEvery = std::chrono::milliseconds(500);
constexpr std::size_t kMaxAnswered = 8;
/// Three Diffie-Hellman computations each.
constexpr double kFirstsPerSecond = 15;
constexpr Duration kAnswerKept = std::chrono::seconds(10);
/// Up to one Diffie-Hellman computation each. Per answer, so that the receiver of another answer cannot use them up.
constexpr double kThirdsPerSecond = 5;
constexpr double kThirdsAtOnce = 5;

} // namespace

PairingAgent::PairingAgent(PairingCore &core, TimePoint now)
    : m_core(core), m_limit(core.random, now, kFirstsPerSecond), m_callDue(now)
{
    m_core.random.fill(m_token);
}

void PairingAgent::call(TimePoint now)
{
    if (now < m_callDue)
        return;
    const PairingDatagram datagram = pairingCall(m_token);
    for (const Path &path : m_core.config.callTo)
        m_core.outgoing.push(path, datagram);
    m_callDue = now + m_core.jittered(kCallEvery);
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
    std::erase_if(m_answered, [now](const Answered &answered) { return now >= answered.at + kAnswerKept; });
}

void PairingAgent::handleFirst(TimePoint now, const Path &from, ByteView datagram)
{
    // A sender that has not received a call of this window costs no more than a comparison.
    const auto head = firstHead(datagram);
    if (!head || sodium_memcmp(head->token.data(), m_token.data(), m_token.size()) != 0)
        return;
    forgetOldAnswers(now);
    for (const Answered &answered : m_answered) {
        if (answered.path == from && std::equal(datagram.begin(), datagram.end(), answered.first.begin())) {
            m_core.outgoing.push(from, answered.answer);
            return;
        }
    }
    if (!mayCompute(now, from))
        return;
    auto handshake = PairingHandshake::begin(noise::Role::Responder, *m_core.config.identity, m_core.config.passphraseKey.get(),
                                             head->id, head->token, from.carrier);
    if (!handshake || !handshake->takeFirst(datagram))
        return;
    const auto answer = handshake->answer(m_core.about(), m_core.random);
    if (!answer)
        return;
    if (m_answered.size() == kMaxAnswered)
        m_answered.erase(m_answered.begin());
    Answered answered{std::move(*handshake), from, {}, *answer, now, {}};
    std::copy(datagram.begin(), datagram.end(), answered.first.begin());
    m_answered.push_back(std::move(answered));
    m_core.outgoing.push(from, *answer);
}

std::optional<PairingConfirmation> PairingAgent::handleThird(TimePoint now, const Path &from, ByteView datagram)
{
    forgetOldAnswers(now);
    const auto found = std::find_if(m_answered.begin(), m_answered.end(), [&](const Answered &answered) {
        return answered.path == from && answered.handshake.id() == sealedPairing(datagram);
    });
    if (found == m_answered.end() || !found->thirds.take(now, kThirdsPerSecond, kThirdsAtOnce))
        return std::nullopt;
    const auto about = found->handshake.takeThird(datagram);
    if (!about) {
        m_core.hintAtPassphrase(now);
        return std::nullopt;
    }
    const PublicKey key = found->handshake.peer();
    auto voice = std::move(found->handshake).finish();
    m_answered.erase(found);
    if (!voice || !m_core.mayShow(key))
        return std::nullopt;
    return PairingConfirmation({key, about->name, about->roleAsked, from}, std::move(*voice),
                               about->wantPresharedKey && m_core.config.wantPresharedKey, now);
}

} // namespace skyseal::channel
