// The protection of MAVLink in force: the operator's, or the one that a measurement sets temporarily on links that stay open.
// Both ends agree on the framing when a session begins, so the caller must end sessions that no longer match a changed setting.
// A plain value; no I/O.
#pragma once

#include "core/channel/policy.h"
#include "core/engine/common/secure_mode.h"
#include "core/engine/station/protection.h"

#include <optional>
#include <vector>

namespace skyseal::engine {

class SecuritySettings
{
public:
    /// `preferred`: sessions begin with this suite if both ends permit it.
    SecuritySettings(SecureMode mode, channel::Policy policy, std::optional<crypto::SuiteId> preferred);

    SecureMode mode() const;
    channel::Policy policy() const;
    /// A measurement of plain MAVLink is in progress.
    bool isPlain() const { return m_protection == Protection::Plain; }

    void setAllowResearch(bool allow) { m_policy.allowResearch = allow; }
    /// Suites weaker than this one are not offered.
    void setWeakestSuite(crypto::SuiteId weakest);

    /// Replaces the configured protection; nullopt restores it. Returns true if sessions that are up must end.
    bool setProtection(std::optional<Protection> protection);
    /// Every session begins with this suite, in place of the preferred one; nullopt restores the preference.
    void holdSuite(std::optional<crypto::SuiteId> suite) { m_heldSuite = suite; }
    /// The next session begins with this suite; nullopt: with the preferred one.
    void setNextSuite(std::optional<crypto::SuiteId> suite) { m_nextSuite = suite; }
    /// The suite for a session that has just come up; nullopt: the negotiated one.
    std::optional<crypto::SuiteId> takeFirstSuite();

private:
    SecureMode m_mode;
    channel::Policy m_policy;
    std::vector<crypto::SuiteId> m_configuredSuites; ///< including weak ones
    std::optional<crypto::SuiteId> m_preferredSuite;
    std::optional<Protection> m_protection;
    std::optional<crypto::SuiteId> m_heldSuite, m_nextSuite;
};

} // namespace skyseal::engine
