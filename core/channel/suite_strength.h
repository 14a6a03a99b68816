// Restricts an offer to the suites that are strong enough; crypto::SuiteStrength is the order.
#pragma once

#include "core/crypto/suite.h"

#include <vector>

namespace skyseal::channel {

/// The suites that are at least as strong as `weakest`, in the given order.
std::vector<crypto::SuiteId> notWeakerThan(crypto::SuiteId weakest, const std::vector<crypto::SuiteId> &suites);

} // namespace skyseal::channel
