// The head of a sealed record, and what is authenticated beside it.
//
//   first byte | connection id 2 | counter 3 | ciphertext | tag         22 bytes more than the frames, over UDP
//   first byte | counter 3 | ciphertext | tag                           20 on a serial pair
//
// Little-endian, as MAVLink is. Only the epoch's two low bits travel; at most three epochs are live, so they suffice.
#pragma once

#include "core/base/bytes.h"
#include "core/channel/wire_format.h"
#include "core/crypto/suite.h"

#include <array>
#include <optional>

namespace skyseal::channel {

inline constexpr std::size_t kRecordHeaderLength = 6;
inline constexpr std::size_t kSingleHeaderLength = 4;
/// Shorter than a header and a tag is no record of any suite.
inline constexpr std::size_t kMinRecord = kSingleHeaderLength + 16;

/// A header that was read, or is to be written. `connection` means nothing in a single record.
struct RecordHeader
{
    DatagramKind kind = DatagramKind::Record;
    std::uint8_t epochBits = 0;
    ConnectionId connection{};
    std::uint32_t counter = 0; ///< below 2^24

    std::size_t length() const { return kind == DatagramKind::Record ? kRecordHeaderLength : kSingleHeaderLength; }
    /// Writes `length()` bytes to the front of `out`, which has them.
    void write(MutableByteView out) const;
    /// nullopt for another version or kind, and for fewer bytes than a header and a tag take.
    static std::optional<RecordHeader> read(ByteView datagram);
};

/// Everything that is authenticated and not encrypted: the header as it travels, and what it does not say.
class AssociatedData
{
public:
    AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier);
    ByteView view() const { return ByteView(m_bytes).first(m_size); }

private:
    std::array<std::uint8_t, kRecordHeaderLength + 3> m_bytes;
    std::size_t m_size;
};

} // namespace skyseal::channel
