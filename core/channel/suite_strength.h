// Order of the suites by strength, so that a person can set the weakest one that is allowed.
#pragma once

#include "core/crypto/suite.h"

#include <vector>

namespace skyseal::channel {

/// Greater is stronger; suites of equal strength have no known difference.
///   4  chacha20-poly1305, aes-256-gcm: constructions that were standardised and studied as a whole
///   3  aes-256-ctr, chacha20 with HMAC: sound by the theorem for encrypt-then-MAC, but put together here
///   2  aes-256-cbc with HMAC: the same, with padding and a second key for its IV; of the sound ones it has the most that
///      an implementation can get wrong
///   1  rc4 with HMAC: a broken cipher, for research
///   0  none
int strengthOf(crypto::SuiteId suite);

/// Returns those of `suites` that are at least as strong as `weakest`, in their order.
std::vector<crypto::SuiteId> notWeakerThan(crypto::SuiteId weakest, const std::vector<crypto::SuiteId> &suites);

} // namespace skyseal::channel
