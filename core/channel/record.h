// The header of a sealed record and its associated data (PROTOCOL.md, section 6).
//
//   first byte | connection id 2 | counter 3 | ciphertext | tag         22 bytes of overhead, over UDP
//   first byte | counter 3 | ciphertext | tag                           20 bytes on a serial carrier
//
// Little-endian, like MAVLink. The first byte has two bits of the epoch, enough for three live epochs.
#pragma once

#include "core/base/bytes.h"
#include "core/base/weakness.h"
#include "core/channel/wire_format.h"
#include "core/crypto/suite.h"

#include <array>
#include <cstring>
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
    /// Writes length() bytes to `out`, which must have that size.
    void write(MutableByteView out) const;
    /// Returns nullopt for another version or kind, and for fewer bytes than a header and a tag.
    static std::optional<RecordHeader> read(ByteView datagram);
};

/// The counter of a record as the input of the cipher's nonce.
inline std::uint64_t nonceOf(std::uint32_t counter)
{
    return weakened(Weakness::SharedNonce) ? 0 : counter;
}

/// Associated data: the header on the wire and the implicit fields (suite, direction, carrier).
class AssociatedData
{
public:
    /// `header`: the bytes of a received header of either kind.
    AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier);
    /// The same for a header to send. Reading it back from the bytes just written one by one would stall on the pending
    /// stores.
    AssociatedData(const RecordHeader &header, crypto::SuiteId suite, Direction direction, Carrier carrier);
    ByteView view() const { return ByteView(m_bytes).first(weakened(Weakness::NoAssociatedData) ? 0 : m_size); }

private:
    void add(crypto::SuiteId suite, Direction direction, Carrier carrier);

    std::array<std::uint8_t, kRecordHeaderLength + 3> m_bytes;
    std::size_t m_size; ///< including the three bytes of add()
};

// Inline: called for every record, from one place each.

inline void RecordHeader::write(MutableByteView out) const
{
    std::size_t at = 0;
    out[at++] = firstByte(kind, epochBits);
    if (kind == DatagramKind::Record) {
        const auto id = static_cast<std::uint16_t>(connection);
        out[at++] = static_cast<std::uint8_t>(id);
        out[at++] = static_cast<std::uint8_t>(id >> 8);
    }
    out[at++] = static_cast<std::uint8_t>(counter);
    out[at++] = static_cast<std::uint8_t>(counter >> 8);
    out[at++] = static_cast<std::uint8_t>(counter >> 16);
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

inline AssociatedData::AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier)
    : m_size(header.size() + 3) // of either kind of header
{
    // Two constant lengths: the compiler makes a few moves of each copy.
    if (header.size() == kRecordHeaderLength)
        std::memcpy(m_bytes.data(), header.data(), kRecordHeaderLength);
    else
        std::memcpy(m_bytes.data(), header.data(), kSingleHeaderLength);
    add(suite, direction, carrier);
}

inline AssociatedData::AssociatedData(const RecordHeader &header, crypto::SuiteId suite, Direction direction, Carrier carrier)
    : m_size(header.length() + 3)
{
    header.write(m_bytes);
    add(suite, direction, carrier);
}

inline void AssociatedData::add(crypto::SuiteId suite, Direction direction, Carrier carrier)
{
    const std::uint32_t direct = weakened(Weakness::NoDirections) ? 0 : static_cast<std::uint32_t>(direction);
    const std::uint32_t bytes = static_cast<std::uint32_t>(suite) | direct << 8 | static_cast<std::uint32_t>(carrier) << 16;
    std::uint8_t *const end = m_bytes.data() + m_size;
    end[-3] = static_cast<std::uint8_t>(bytes);
    end[-2] = static_cast<std::uint8_t>(bytes >> 8);
    end[-1] = static_cast<std::uint8_t>(bytes >> 16);
}

} // namespace skyseal::channel
