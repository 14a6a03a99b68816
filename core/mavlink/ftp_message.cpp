#include "core/mavlink/ftp_message.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

namespace skyseal::mavlink {

namespace {

constexpr auto kCrcTable = [] {
    std::array<std::uint32_t, 256> out{};
    for (std::uint32_t i = 0; i < 256; ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit)
            value = (value >> 1) ^ ((value & 1) ? 0xEDB88320u : 0u);
        out[i] = value;
    }
    return out;
}();

} // namespace

FtpMessage FtpMessage::decode(const Payload &payload)
{
    ByteReader in(payload);
    FtpMessage out;
    out.sequence = in.u16();
    out.session = in.u8();
    out.opcode = in.u8();
    out.size = in.u8();
    out.requested = in.u8();
    out.burstComplete = in.u8() != 0;
    in.u8(); // padding
    out.offset = in.u32();
    const ByteView data = in.bytes(kMostData);
    std::copy(data.begin(), data.end(), out.data.begin());
    return out;
}

FtpMessage::Payload FtpMessage::encode() const
{
    Payload payload{};
    ByteWriter out(payload);
    out.u16(sequence);
    out.u8(session);
    out.u8(opcode);
    out.u8(size);
    out.u8(requested);
    out.u8(burstComplete);
    out.u8(0);
    out.u32(offset);
    out.bytes(content());
    return payload;
}

bool FtpMessage::append(ByteView bytes)
{
    if (bytes.size() + size > kMostData)
        return false;
    std::copy(bytes.begin(), bytes.end(), data.begin() + size);
    size = static_cast<std::uint8_t>(size + bytes.size());
    return true;
}

bool FtpMessage::appendNumber(std::uint32_t value)
{
    std::array<std::uint8_t, 4> bytes;
    ByteWriter(bytes).u32(value);
    return append(bytes);
}

std::optional<std::uint32_t> FtpMessage::number() const
{
    ByteReader in(content());
    const std::uint32_t value = in.u32();
    return in.ok() ? std::optional(value) : std::nullopt;
}

std::optional<std::uint8_t> FtpMessage::error() const
{
    if (opcode != MAV_FTP_OPCODE_NAK)
        return std::nullopt;
    return size > 0 ? data[0] : std::uint8_t(MAV_FTP_ERR_FAIL);
}

void FtpMessage::refuse(MAV_FTP_ERR error)
{
    opcode = MAV_FTP_OPCODE_NAK;
    size = 1;
    data = {};
    data[0] = static_cast<std::uint8_t>(error);
}

std::uint32_t ftpChecksum(ByteView bytes, std::uint32_t checksum)
{
    for (const std::uint8_t byte : bytes)
        checksum = kCrcTable[(checksum ^ byte) & 0xFF] ^ (checksum >> 8);
    return checksum;
}

} // namespace skyseal::mavlink
