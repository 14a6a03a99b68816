#include "core/channel/permissions.h"

namespace skyseal::channel {

std::vector<crypto::SuiteId> Permissions::suites() const
{
    auto suites = m_initiator ? permittedSuites(m_ours, m_peers) : permittedSuites(m_peers, m_ours);
    // Clear frames within a session have no format; the number of the suite is reserved (PROTOCOL.md, section 4).
    std::erase(suites, crypto::SuiteId::None);
    return suites;
}

bool Permissions::permits(crypto::SuiteId suite) const
{
    return holds(suites(), suite);
}

bool Permissions::permittedHere(crypto::SuiteId suite) const
{
    const bool research = crypto::suiteInfo(suite).research;
    return suite != crypto::SuiteId::None && holds(m_ours.suites, suite) && (!research || m_ours.allowResearch);
}

Framing Permissions::framing() const
{
    return inlineAllowed() && inlineWanted(m_ours, m_peers) ? Framing::Inline : Framing::Sealed;
}

} // namespace skyseal::channel
