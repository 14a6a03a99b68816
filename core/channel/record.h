// The header of a sealed record and its associated data (PROTOCOL.md, section 6).
//
//   first byte | connection id 2 | counter 3 | ciphertext | tag         22 bytes of overhead, over UDP
//   first byte | counter 3 | ciphertext | tag                           20 bytes on a serial carrier
//
// Little-endian, like MAVLink. The first byte has two bits of the epoch, enough for three live epochs.
#pragma once

#include "core/base/bytes.h"
#include "core/channel/wire_format.h"
#include "core/crypto/suite.h"

#include <array>
#include <optional>

namespace skyseal::channel {

inline constexpr std::size_t kRecordHeaderLength = 6;
inline constexpr std::size_t kSingleHeaderLength = 4;
/// Smallest record of any suite: header and tag.
inline constexpr std::size_t kMinRecord = kSingleHeaderLength + 16;

/// A record header. `connection` is unused in a single record.
struct RecordHeader
{
    DatagramKind kind = DatagramKind::Record;
    std::uint8_t epochBits = 0;
    ConnectionId connection{};
    std::uint32_t counter = 0; ///< below 2^24

    std::size_t length() const { return kind == DatagramKind::Record ? kRecordHeaderLength : kSingleHeaderLength; }
    /// The length() bytes as a number, the first one the lowest.
    std::uint64_t packed() const;
    /// Writes length() bytes to `out`, which must have that size.
    void write(MutableByteView out) const;
    /// Returns nullopt for another version or kind, and for fewer bytes than a header and a tag.
    static std::optional<RecordHeader> read(ByteView datagram);
};

/// The counter of a record as the input of the cipher's nonce.
std::uint64_t nonceOf(std::uint32_t counter);

/// Associated data: the header on the wire and the implicit fields (suite, direction, carrier).
class AssociatedData
{
public:
    /// `header`: the bytes of a received header of either kind.
    AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier);
    /// The same for a header to send.
    AssociatedData(const RecordHeader &header, crypto::SuiteId suite, Direction direction, Carrier carrier);
    ByteView view() const { return ByteView(m_bytes).first(m_size); }

private:
    /// `header`: its `length` bytes, the first one the lowest.
    void set(std::uint64_t header, std::size_t length, crypto::SuiteId suite, Direction direction, Carrier carrier);

    std::array<std::uint8_t, kRecordHeaderLength + 3> m_bytes;
    std::size_t m_size;
};

// Inline: called for every record, from one place each.

inline std::uint64_t RecordHeader::packed() const
{
    const std::uint64_t first = firstByte(kind, epochBits);
    return kind == DatagramKind::Record
        ? first | static_cast<std::uint64_t>(connection) << 8 | static_cast<std::uint64_t>(counter) << 24
        : first | static_cast<std::uint64_t>(counter) << 8;
}

inline void RecordHeader::write(MutableByteView out) const
{
    const std::uint64_t bytes = packed();
    for (std::size_t i = 0; i < kSingleHeaderLength; ++i)
        out[i] = static_cast<std::uint8_t>(bytes >> 8 * i);
    if (kind == DatagramKind::Record) {
        out[4] = static_cast<std::uint8_t>(bytes >> 32);
        out[5] = static_cast<std::uint8_t>(bytes >> 40);
    }
}

inline std::optional<RecordHeader> RecordHeader::read(ByteView datagram)
{
    if (datagram.size() < kMinRecord || !isOurs(datagram[0]) || versionOf(datagram[0]) != kProtocolVersion)
        return std::nullopt;
    RecordHeader header;
    header.kind = kindOf(datagram[0]);
    header.epochBits = datagram[0] & 3;
    std::size_t at = 1;
    if (header.kind == DatagramKind::Record) {
        if (datagram.size() < kRecordHeaderLength + kMacLength)
            return std::nullopt;
        header.connection = static_cast<ConnectionId>(datagram[1] | datagram[2] << 8);
        at = 3;
    } else if (header.kind != DatagramKind::SingleRecord) {
        return std::nullopt;
    }
    header.counter = static_cast<std::uint32_t>(datagram[at] | datagram[at + 1] << 8 | datagram[at + 2] << 16);
    return header;
}

} // namespace skyseal::channel
