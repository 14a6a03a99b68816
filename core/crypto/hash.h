// BLAKE2b (RFC 7693) by libsodium: the handshake's hash, short keyed MACs, and HMAC as Noise defines it.
#pragma once

#include "core/base/bytes.h"

#include <array>
#include <initializer_list>

namespace skyseal::crypto {

inline constexpr std::size_t kBlake2bLength = 64;
inline constexpr std::size_t kBlake2bBlock = 128;

using Hash64 = std::array<std::uint8_t, kBlake2bLength>;

/// Unkeyed BLAKE2b-512 over the concatenated parts.
Hash64 blake2b(std::initializer_list<ByteView> parts);

/// BLAKE2b over the concatenated parts with an output of 16..64 bytes, the size of `out`; each length is a different function.
void blake2b(MutableByteView out, std::initializer_list<ByteView> parts);

/// Keyed BLAKE2b, `key` of 16..64 bytes, `out` of 16..64: a MAC without the HMAC construction (mac1 and cookies).
void keyedBlake2b(MutableByteView out, ByteView key, std::initializer_list<ByteView> parts);

/// HMAC (RFC 2104) with BLAKE2b-512 as its hash: the HMAC-HASH of the Noise specification. `out` may be one of the inputs.
void hmacBlake2b(std::span<std::uint8_t, kBlake2bLength> out, ByteView key, std::initializer_list<ByteView> parts);

} // namespace skyseal::crypto
