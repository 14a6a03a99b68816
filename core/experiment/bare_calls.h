// The library calls that sealing or opening a record cannot do without, made as cheaply as the libraries' documentation
// allows: the reference that complete records are compared with. They are derived from the primitives of each suite's
// descriptor (core/crypto/suite_primitives.h).
//
// AEADs: libsodium's one-shot call; with OpenSSL nonce, associated data, text and tag. The other suites: the cipher with its
// IV set (RC4: with a new key, 768 bytes discarded), then HMAC-SHA-256 from copied hash states. AES-CBC is given an IV; the
// suite has to compute one, which the comparison charges to the suite.
#pragma once

#include "core/crypto/suite.h"

#include <cstddef>
#include <functional>

namespace skyseal::experiment {

/// One call on `size` bytes, at most kMostBareBytes.
using BareCall = std::function<void(std::size_t size)>;

inline constexpr std::size_t kMostBareBytes = 1200;
/// Bytes of associated data of a record: first byte, connection id, counter, suite, direction, carrier.
inline constexpr std::size_t kAssociated = 9;

enum class RecordOperation { Seal, Open };

/// The cipher without authentication; of an AEAD, the stream cipher inside. Empty if the suite is not available.
BareCall bareCipher(crypto::SuiteId suite, RecordOperation operation);
/// Cipher and authentication. Opening includes a fresh copy of the sealed bytes, as a socket delivers them. Empty if the
/// suite is not available.
BareCall bareRecord(crypto::SuiteId suite, RecordOperation operation);

} // namespace skyseal::experiment
