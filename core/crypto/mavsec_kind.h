// The two ciphers of the code published with the paper MAVSec (2019); see mavsec_cipher.h.
#pragma once

#include <cstdint>
#include <string_view>

namespace skyseal::crypto {

enum class MavsecKind : std::uint8_t { ChaCha20, Aes256Ctr };

/// As in options: "chacha20".
constexpr std::string_view name(MavsecKind kind)
{
    return kind == MavsecKind::ChaCha20 ? "chacha20" : "aes-256-ctr";
}

/// How often the cipher runs. The result is the same, since its key stream begins anew with every frame.
enum class MavsecWork : std::uint8_t {
    Once,     ///< the key stream is kept
    EachFrame ///< as in the published code: for measurements of its cost
};

/// Number of ChaCha20's first block in the published code.
inline constexpr std::uint32_t kPublishedMavsecCounter = 1;

} // namespace skyseal::crypto
