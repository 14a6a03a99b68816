// The reasons for which a handshake step fails.
#pragma once

#include <cstdint>

namespace skyseal::noise {

enum class NoiseError : std::uint8_t {
    MissingKey,       ///< a cipher without a key, or the second message without a psk
    OutOfTurn,        ///< it is the other side's turn, or the handshake is complete
    Unfinished,       ///< `finish` before the last message
    TooLong,          ///< the message would exceed 65535 bytes
    NoRoom,           ///< the caller's buffer is too small
    Truncated,        ///< the message is shorter than its fixed parts
    DecryptionFailed, ///< forged, damaged, or other keys, psk or prologue
    BadPublicKey,     ///< the Diffie-Hellman result is all zero: a point of small order
    NonceExhausted,   ///< 2^64 - 1 messages under one key
};

} // namespace skyseal::noise
