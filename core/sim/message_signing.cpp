#include "core/sim/message_signing.h"

namespace skyseal::sim {

using mavlink::SignatureVerdict;

bool MessageSigning::accepts(const mavlink::Frame &frame, LinkTrust trust)
{
    if (!m_live)
        return true;
    m_live->verifier.advanceTo(m_live->signer.lastTime());
    const SignatureVerdict verdict = m_live->verifier.check(frame);
    m_live->signer.advanceTo(m_live->verifier.newestTime());
    const bool isRadios = frame.messageId() == mavlink::RadioStatus::kId || frame.messageId() == mavlink::Radio::kId;
    return verdict == SignatureVerdict::Good || isRadios || trust == LinkTrust::Trusted;
}

void MessageSigning::setUp(TimePoint now, const mavlink::SetupSigning &setup)
{
    m_key = Key32(std::span<const std::uint8_t, Key32::size()>(setup.secret_key));
    m_saved = setup.initial_timestamp;
    m_saveDue = now + kSaveEvery;
    restart();
}

void MessageSigning::restart()
{
    m_live.reset();
    if (m_key.isZero() && m_saved == 0)
        return;
    constexpr std::uint8_t kFirstLink = 0;
    const mavlink::SigningTime time = std::min(m_saved, mavlink::kMaxSigningTime - kAfterSaved) + kAfterSaved;
    m_live.emplace(Live{{m_key.clone(), kFirstLink, time}, {m_key.clone(), time, kMostStreams}});
}

void MessageSigning::noteTime(WallTime time)
{
    if (m_live)
        m_live->signer.advanceTo(mavlink::signingTime(time));
}

void MessageSigning::saveIfDue(TimePoint now)
{
    if (!m_live || now < m_saveDue)
        return;
    m_saveDue = now + kSaveEvery;
    m_saved = std::max(m_saved, m_live->signer.lastTime());
}

} // namespace skyseal::sim
