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

bool holds(const std::vector<crypto::SuiteId> &suites, crypto::SuiteId wanted);

/// Makes the offer of a policy: research suites only with `allowResearch`, None only as `allowPlain`. Suites that do not fit
/// into the list of the handshake are not offered: the list ends before the first of them (section 4.3).
SuiteOffer offerOf(const Policy &policy);

/// Returns true if both ends allow inline framing and at least one prefers it.
bool inlineWanted(const SuiteOffer &one, const SuiteOffer &other);

/// Returns the suites that both ends allow, in the initiator's order; research suites only if both allow them; None last, and
/// only if both allow plain.
std::vector<crypto::SuiteId> permittedSuites(const SuiteOffer &initiator, const SuiteOffer &responder);

/// Returns the suite with which a session begins: the first permitted one that is neither research nor None, which take an
/// explicit switch. Returns nullopt if there is none.
std::optional<crypto::SuiteId> chooseSuite(const SuiteOffer &initiator, const SuiteOffer &responder);

} // namespace skyseal::channel
