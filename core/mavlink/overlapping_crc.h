// Checks the checksums of frames that may overlap, so that damaged or hostile bytes cost no more than valid frames: each
// byte goes through the CRC once, however many frames seem to begin before it. No I/O, no clock, no allocation.
//
// The CRC is linear over GF(2). With P(i) the state after the bytes before i, from a state of zero,
//
//     state after the bytes [from, to), from kCrcStart  =  P(to) xor advance(P(from) xor kCrcStart, to - from)
//
// where advance(s, n) is the state that s becomes over n zero bytes: a linear map of 16 bits, read from a table. As long as
// nothing is damaged, frames do not overlap and are checked directly.
//
// For bytes of strangers, the work for bytes that are not frames is limited as well: on average of a stream, and for datagrams
// of 1,472 bytes or more, to twice that of random bytes. A shorter datagram may cost more than that, since the frame after a
// damaged one must be found: a quarter of its bytes, and 528.
#pragma once

#include "core/mavlink/crc.h"

namespace skyseal::mavlink {

/// Limit of the bytes that go through the CRC without being part of a frame. Of random bytes 32 % do so (scan_work_test).
enum class WastedWork : std::uint8_t {
    Unlimited, ///< for recorded or sealed bytes: no frame is missed, at any cost
    OfDatagram,
    OfStream
};

class OverlappingCrc
{
public:
    /// The longest range: a header without its first byte, and a payload.
    static constexpr std::size_t kLongestRange = 9 + 255;

    explicit OverlappingCrc(WastedWork limit = WastedWork::Unlimited) : m_limit(limit) {}

    /// Returns true if the limit allows a check of these bytes of a datagram or stream, of which `received` bytes are known.
    bool affords(std::size_t offset, std::size_t bytes, std::size_t received) const;

    /// Returns true if the checksum over `bytes` and `crcExtra` is `expected`. `bytes`: at most kLongestRange, found at
    /// `offset` of the stream. The offset must not be less than in the call before.
    bool matches(std::size_t offset, ByteView bytes, std::uint8_t crcExtra, std::uint16_t expected)
    {
        if (m_overlapping)
            return matchesByPrefixes(offset, bytes, crcExtra, expected);
        m_processed += bytes.size();
        if (crcStep(crcAccumulate(kCrcStart, bytes), crcExtra) == expected)
            return true;
        m_wasted += bytes.size();
        m_overlapping = true;
        beginPrefixes(offset);
        return false;
    }
    /// Call before ranges are checked that may overlap each other; matches() does so when it finds damage.
    void expectOverlap();

    /// The number of bytes that went through the CRC: at most those of the stream plus kLongestRange, for any content.
    std::uint64_t bytesProcessed() const { return m_processed; }

private:
    static constexpr std::size_t kKept = 512; ///< a power of two, more than kLongestRange

    std::uint16_t &prefix(std::size_t offset) { return m_prefixes[offset % kKept]; }
    bool matchesByPrefixes(std::size_t offset, ByteView bytes, std::uint8_t crcExtra, std::uint16_t expected);
    std::size_t unprocessed(std::size_t offset, std::size_t bytes) const;
    void beginPrefixes(std::size_t offset);
    void extendPrefixes(std::size_t offset, ByteView bytes);

    WastedWork m_limit;
    bool m_overlapping = false; ///< ranges are checked by prefixes
    std::size_t m_end = 0;      ///< the last offset whose prefix is known
    std::uint64_t m_processed = 0;
    std::uint64_t m_wasted = 0;                  ///< of these, for bytes that are not frames
    std::array<std::uint16_t, kKept> m_prefixes; ///< P, by offset; each is written before it is read
};

} // namespace skyseal::mavlink
