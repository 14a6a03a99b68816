// The library calls that sealing or opening a record cannot do without, called as cheaply as the libraries' documentation
// allows: what complete records are held against.
//
// AEAD: libsodium's one-shot call; for OpenSSL nonce, associated data, text and tag. The others: the cipher with its IV set
// (RC4 with a new key and 768 bytes dropped), and HMAC-SHA-256 from copied hash states. The IV of AES-CBC is given to the
// call: that a record has to make one is not counted in the record's favour.
#pragma once

#include "core/crypto/suite.h"

#include <cstddef>
#include <functional>

namespace skyseal::experiment {

/// One call over so many bytes (at most kMostBareBytes).
using BareCall = std::function<void(std::size_t size)>;

inline constexpr std::size_t kMostBareBytes = 1200;

enum class Direction { Seal, Open };

/// The cipher without authentication: of the AEADs the stream cipher inside. Empty when the suite is not available.
BareCall bareCipher(crypto::SuiteId suite, Direction direction);
/// Cipher and authentication. Opening works on a fresh copy of sealed bytes, as it does on what a socket gives.
BareCall bareRecord(crypto::SuiteId suite, Direction direction);

} // namespace skyseal::experiment
