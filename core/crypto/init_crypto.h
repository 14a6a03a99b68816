// Initialization of the cryptographic libraries, once per process.
#pragma once

namespace skyseal::crypto {

/// Initializes libsodium (selects implementations for this CPU, opens the system's random source). Call it at the start of
/// main(), before threads start and before anything else in core/crypto; further calls have no effect. Returns false if the
/// system provides no randomness, or OpenSSL no HMAC-SHA-256; the program must then exit.
[[nodiscard]] bool initCrypto();

} // namespace skyseal::crypto
