// The two ciphers of the code published with the paper MAVSec (2019); see mavsec_cipher.h.
#pragma once

#include <cstdint>

namespace skyseal::crypto {

enum class MavsecKind : std::uint8_t { ChaCha20, Aes256Ctr };

/// Number of ChaCha20's first block in the published code.
inline constexpr std::uint32_t kPublishedMavsecCounter = 1;

} // namespace skyseal::crypto
