#include "core/sim/ftp_message.h"

#include "core/base/byte_reader.h"
#include "core/base/byte_writer.h"

namespace skyseal::sim {

FtpMessage FtpMessage::decode(const Payload &payload)
{
    ByteReader in(payload);
    FtpMessage out;
    out.sequence = in.u16();
    out.session = in.u8();
    out.opcode = in.u8();
    out.size = in.u8();
    out.requestOpcode = in.u8();
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
    out.u8(requestOpcode);
    out.u8(burstComplete);
    out.u8(0);
    out.u32(offset);
    out.bytes(content());
    return payload;
}

bool FtpMessage::append(ByteView bytes)
{
    if (bytes.size() > kMostData - size)
        return false;
    std::copy(bytes.begin(), bytes.end(), data.begin() + size);
    size = static_cast<std::uint8_t>(size + bytes.size());
    return true;
}

} // namespace skyseal::sim
