#include "core/channel/record.h"

#include "core/crypto/store_integer.h"

namespace skyseal::channel {

std::uint64_t nonceOf(std::uint32_t counter)
{
    return counter;
}

AssociatedData::AssociatedData(ByteView header, crypto::SuiteId suite, Direction direction, Carrier carrier)
{
    std::uint64_t bytes = static_cast<std::uint32_t>(header[0] | header[1] << 8 | header[2] << 16)
        | static_cast<std::uint64_t>(header[3]) << 24;
    if (header.size() == kRecordHeaderLength)
        bytes |= static_cast<std::uint64_t>(header[4] | header[5] << 8) << 32;
    set(bytes, header.size(), suite, direction, carrier);
}

AssociatedData::AssociatedData(const RecordHeader &header, crypto::SuiteId suite, Direction direction, Carrier carrier)
{
    set(header.packed(), header.length(), suite, direction, carrier);
}

/// All in two stores: the cipher reads the bytes at once, and a load that is wider than the pending stores waits for them.
void AssociatedData::set(std::uint64_t header, std::size_t length, crypto::SuiteId suite, Direction direction, Carrier carrier)
{
    const std::uint64_t fields = static_cast<std::uint64_t>(suite) | static_cast<std::uint64_t>(direction) << 8
        | static_cast<std::uint64_t>(carrier) << 16;
    crypto::storeLittleEndian64(m_bytes.data(), header | fields << 8 * length);
    m_bytes.back() = static_cast<std::uint8_t>(carrier); // the ninth byte, of a header of six
    m_size = length + 3;
}

} // namespace skyseal::channel
