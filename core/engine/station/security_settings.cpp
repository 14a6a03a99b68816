#include "core/engine/station/security_settings.h"

#include "core/channel/suite_strength.h"

#include <utility>

namespace skyseal::engine {

SecuritySettings::SecuritySettings(SecureMode mode, channel::Policy policy, std::optional<crypto::SuiteId> preferred)
    : m_mode(mode), m_policy(std::move(policy)), m_configuredSuites(m_policy.suites), m_preferredSuite(preferred)
{}

SecureMode SecuritySettings::mode() const
{
    if (!m_protection)
        return m_mode;
    return isPlain() ? SecureMode::Off : SecureMode::Required;
}

channel::Policy SecuritySettings::policy() const
{
    channel::Policy out = m_policy;
    if (m_protection)
        out.allowInline = out.preferInline = *m_protection == Protection::Inline;
    return out;
}

void SecuritySettings::setWeakestSuite(crypto::SuiteId weakest)
{
    m_policy.suites = channel::notWeakerThan(weakest, m_configuredSuites);
}

bool SecuritySettings::setProtection(std::optional<Protection> protection)
{
    const auto kindOf = [](std::optional<Protection> one) { return one.value_or(Protection::Sealed); };
    const bool inlineBefore = policy().allowInline;
    const auto before = std::exchange(m_protection, protection);
    const bool changed = policy().allowInline != inlineBefore || kindOf(before) != kindOf(protection);
    return changed && before != Protection::Plain;
}

std::optional<crypto::SuiteId> SecuritySettings::takeFirstSuite()
{
    const auto next = std::exchange(m_nextSuite, std::nullopt);
    return m_heldSuite ? m_heldSuite : next ? next : m_preferredSuite;
}

} // namespace skyseal::engine
