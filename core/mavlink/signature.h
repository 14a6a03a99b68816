// The signature block of MAVLink 2 as it is read without the key: https://mavlink.io/en/guide/message_signing.html
// A signed frame ends in a link id, 48 bits of time and the first 48 bits of SHA-256 over the key and everything
// before it.
#pragma once

#include "core/mavlink/frame.h"

#include <cstddef>
#include <cstdint>

namespace skyseal::mavlink {

/// Units of 10 µs since 2015-01-01 UTC, 48 bits.
using SigningTime = std::uint64_t;
inline constexpr SigningTime kMaxSigningTime = (SigningTime(1) << 48) - 1;
inline constexpr SigningTime kSigningMinute = 6'000'000;

/// Of a signed frame.
std::uint8_t signatureLinkId(ByteView frame);
SigningTime signatureTime(ByteView frame);
inline std::uint8_t signatureLinkId(const Frame &frame)
{
    return signatureLinkId(frame.bytes());
}
inline SigningTime signatureTime(const Frame &frame)
{
    return signatureTime(frame.bytes());
}

enum class SignatureVerdict : std::uint8_t {
    Good,
    Unsigned,
    Wrong,         ///< made with another key, or changed in transit
    Replayed,      ///< not newer than the last one of its stream
    TooOld,        ///< a new stream that begins more than a minute behind
    TooManyStreams ///< a new stream beyond the greatest number of streams
};
inline constexpr std::size_t kSignatureVerdicts = 6;

} // namespace skyseal::mavlink
