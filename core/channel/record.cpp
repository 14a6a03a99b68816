#include "core/channel/record.h"


#include <algorithm>

namespace skyseal::channel {

void RecordHeader::write(MutableByteView out) const
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

std::optional<RecordHeader> RecordHeader::read(ByteView datagram)
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

AssociatedData::AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier)
    : m_size(header.size() + 3)
{
    const auto end = std::copy(header.begin(), header.end(), m_bytes.begin());
    end[0] = static_cast<std::uint8_t>(suite);
    end[1] = static_cast<std::uint8_t>(direction);
    end[2] = static_cast<std::uint8_t>(carrier);
}

} // namespace skyseal::channel
