// Messages within a stream of bytes, for a line that only two share: Consistent Overhead Byte Stuffing (Cheshire and Baker,
// IEEE/ACM Transactions on Networking 7(2), 1999). A message is written without zeros, at one byte more and another for
// each 254, and a zero ends it; so whatever the line did to one message, the next begins after a zero.
#pragma once

#include "core/channel/wire_format.h"

#include <array>
#include <concepts>

namespace skyseal::channel {

/// The most that a message takes: a code byte for each 254 bytes begun, and a zero on both sides.
inline constexpr std::size_t kMaxCobs = kMaxDatagram + kMaxDatagram / 254 + 1 + 2;

/// Writes a message of 1 to kMaxDatagram bytes and its end to `out`: how many bytes, 0 when it is none or does not fit.
/// Before other messages than records there is a zero as well: the line may have been noise until now.
std::size_t writeCobs(ByteView message, MutableByteView out);

/// One direction of a line. Bounded: what is too long, cut short or no COBS is forgotten at the next zero, and counted.
class CobsReader
{
public:
    /// Takes the next piece and calls `deliver(MutableByteView)` for each message that is complete; it may be changed in
    /// place and lives during that call.
    template<std::invocable<MutableByteView> Deliver> void feed(ByteView piece, Deliver &&deliver)
    {
        for (const std::uint8_t byte : piece) {
            if (byte != 0)
                take(byte);
            else if (const std::size_t size = end(); size > 0)
                deliver(MutableByteView(m_message).first(size));
        }
    }

    /// Zeros that ended what was no message.
    std::uint64_t damaged() const { return m_damaged; }

private:
    void take(std::uint8_t byte);
    /// The size of the message that ends here; 0 when there is none.
    std::size_t end();

    std::array<std::uint8_t, kMaxDatagram> m_message;
    std::size_t m_size = 0;
    std::uint8_t m_left = 0; ///< bytes until the next code byte
    bool m_zeroDue = false;  ///< the block before ended in a zero, unless the message ends here
    bool m_begun = false;
    bool m_bad = false;
    std::uint64_t m_damaged = 0;
};

} // namespace skyseal::channel
