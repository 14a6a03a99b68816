// Suites and framings that both ends of a session permit. The peer's part is what it offered in the handshake; our part
// follows our policy, also during the session.
#pragma once

#include "core/channel/negotiation.h"

namespace skyseal::channel {

class Permissions
{
public:
    /// `ours` must outlive the object; it is read at each call. `inlineAgreed`: both ends allowed inline framing in the
    /// handshake, on a carrier that has it.
    Permissions(const SuiteOffer &ours, SuiteOffer peers, bool initiator, bool inlineAgreed)
        : m_ours(ours), m_peers(std::move(peers)), m_initiator(initiator), m_inlineAgreed(inlineAgreed)
    {}

    const SuiteOffer &offeredByPeer() const { return m_peers; }
    /// Suites that both ends permit, in the initiator's order.
    std::vector<crypto::SuiteId> suites() const;
    bool permits(crypto::SuiteId suite) const;
    bool permittedHere(crypto::SuiteId suite) const;

    bool inlineAgreed() const { return m_inlineAgreed; }
    bool inlineAllowed() const { return m_inlineAgreed && m_ours.allowInline; }
    /// Framing that both ends want, for the suites that have it.
    Framing framing() const;

private:
    const SuiteOffer &m_ours;
    SuiteOffer m_peers;
    bool m_initiator;
    bool m_inlineAgreed;
};

} // namespace skyseal::channel
