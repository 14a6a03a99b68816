// What has to happen once, before the first use of anything in core/crypto.
#pragma once

namespace skyseal::crypto {

/// Prepares libsodium (picks implementations for this CPU, opens the system's random source). Call it at the top of main,
/// before threads start; again is harmless. False when the system offers no randomness: then stop.
[[nodiscard]] bool initCrypto();

} // namespace skyseal::crypto
