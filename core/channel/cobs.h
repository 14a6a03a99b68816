// Framing of messages on serial lines and TCP: Consistent Overhead Byte Stuffing (Cheshire and Baker, IEEE/ACM Transactions on
// Networking 7(2), 1999; PROTOCOL.md, section 2.1). A message is encoded without zeros, with one byte more and another for each
// 254, and ends with a zero, so that the receiver finds the next message after any damage.
#pragma once

#include "core/channel/wire_format.h"

#include <array>
#include <concepts>

namespace skyseal::channel {

/// Longest encoded message: a code byte for each 254 bytes begun, and a zero on both sides.
inline constexpr std::size_t kMaxCobs = kMaxDatagram + kMaxDatagram / 254 + 1 + 2;

/// Encodes a message of 1 to kMaxDatagram bytes into `out`. Returns the number of bytes, 0 if the length is wrong or `out` too
/// small. Handshake and pairing messages get a zero in front, too, since the line may carry noise before.
std::size_t writeCobs(ByteView message, MutableByteView out);

/// Decoder of one direction. Oversized, truncated or invalid frames are dropped at the next delimiter and counted.
class CobsReader
{
public:
    /// Takes the next bytes and calls `deliver(MutableByteView)` for each complete message. The view is valid during the call
    /// and may be changed in place.
    template<std::invocable<MutableByteView> Deliver> void feed(ByteView piece, Deliver &&deliver)
    {
        for (const std::uint8_t byte : piece) {
            if (byte != 0)
                take(byte);
            else if (const std::size_t size = end(); size > 0)
                deliver(MutableByteView(m_message).first(size));
        }
    }

    /// Number of dropped frames.
    std::uint64_t damaged() const { return m_damaged; }

private:
    void take(std::uint8_t byte);
    /// Size of the message that ends here; 0 if there is none.
    std::size_t end();

    std::array<std::uint8_t, kMaxDatagram> m_message;
    std::size_t m_size = 0;
    std::uint8_t m_left = 0; ///< bytes until the next code byte
    bool m_zeroDue = false;  ///< the block before ended with a zero, unless the message ends here
    bool m_begun = false;
    bool m_bad = false;
    std::uint64_t m_damaged = 0;
};

} // namespace skyseal::channel
