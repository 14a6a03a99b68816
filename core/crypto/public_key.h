// A point of Curve25519 as the bytes of RFC 7748.
#pragma once

#include <array>
#include <cstdint>

namespace skyseal::crypto {

using PublicKey = std::array<std::uint8_t, 32>;

} // namespace skyseal::crypto
