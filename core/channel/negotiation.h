// Suites that two ends have in common, and the first suite of a session (PROTOCOL.md, section 4): pure functions of the two
// offers, so that both ends compute the same and the initiator can check the responder's choice.
#pragma once

#include "core/channel/policy.h"
#include "core/crypto/suite.h"

#include <optional>
#include <vector>

namespace skyseal::channel {

/// Suites and framings that one end accepts, as the handshake carries them.
struct SuiteOffer
{
    std::vector<crypto::SuiteId> suites; ///< best first; without None, no suite twice
    bool allowResearch = false;
    bool allowPlain = false;
    bool allowInline = false;
    bool preferInline = false; ///< ignored without `allowInline`

    bool operator==(const SuiteOffer &) const = default;
};

/// The offer that a policy gives: research suites only with `allowResearch`, None only as `allowPlain`.
SuiteOffer offerOf(const Policy &policy);

/// Whether frames are to be sealed in place: both ends allow it and at least one prefers it.
bool inlineWanted(const SuiteOffer &one, const SuiteOffer &other);

/// Every suite that both ends allow, in the initiator's order; research suites only when both allow them, None last
/// and only when both allow plain.
std::vector<crypto::SuiteId> permittedSuites(const SuiteOffer &initiator, const SuiteOffer &responder);

/// The suite that a session begins with: the first one permitted that is neither research nor None, which take an
/// explicit switch. nullopt when there is none.
std::optional<crypto::SuiteId> chooseSuite(const SuiteOffer &initiator, const SuiteOffer &responder);

} // namespace skyseal::channel
