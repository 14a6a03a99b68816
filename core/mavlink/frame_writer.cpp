#include "core/mavlink/frame_writer.h"

#include "core/mavlink/crc.h"
#include "core/mavlink/signing.h"

#include <algorithm>
#include <cstring>

namespace skyseal::mavlink {

MutableByteView writeFrame(MutableByteView out, int version, std::uint8_t sequence, std::uint8_t systemId,
                           std::uint8_t componentId, std::uint32_t messageId, std::uint8_t crcExtra, std::uint8_t minLength,
                           ByteView payload, std::uint8_t incompatFlags)
{
    std::size_t length = std::min<std::size_t>(payload.size(), 255);
    if (version == 2) {
        while (length > 1 && payload[length - 1] == 0)
            --length;
    } else {
        length = std::min<std::size_t>(length, minLength);
    }
    const std::size_t header = version == 2 ? 10 : 6;
    const std::size_t signature = version == 2 && (incompatFlags & kFlagSigned) ? kSignatureLength : 0;
    if (out.size() < header + length + 2 + signature || (version != 2 && messageId > 255))
        return {};
    if (version == 2) {
        const auto idByte = [messageId](int i) { return static_cast<std::uint8_t>(messageId >> (8 * i)); };
        const std::uint8_t fields[] = {kMagic2,       static_cast<std::uint8_t>(length),
                                       incompatFlags, 0,
                                       sequence,      systemId,
                                       componentId,   idByte(0),
                                       idByte(1),     idByte(2)};
        std::memcpy(out.data(), fields, sizeof fields);
    } else {
        const std::uint8_t fields[] = {kMagic1,     static_cast<std::uint8_t>(length),   sequence, systemId,
                                       componentId, static_cast<std::uint8_t>(messageId)};
        std::memcpy(out.data(), fields, sizeof fields);
    }
    std::copy_n(payload.data(), length, out.data() + header); // an empty payload may have no address
    std::uint16_t crc = crcAccumulate(kCrcStart, out.subspan(1, header - 1 + length));
    crc = crcAccumulate(crc, {&crcExtra, 1});
    out[header + length] = static_cast<std::uint8_t>(crc);
    out[header + length + 1] = static_cast<std::uint8_t>(crc >> 8);
    return out.first(header + length + 2 + signature);
}

MutableByteView FrameWriter::write(std::uint32_t messageId, std::uint8_t crcExtra, std::uint8_t minLength, ByteView payload,
                                   MutableByteView out)
{
    const bool isSigned = m_signer && m_version == 2;
    const MutableByteView frame = writeFrame(out, m_version, m_sequence, m_systemId, m_componentId, messageId, crcExtra,
                                             minLength, payload, isSigned ? kFlagSigned : std::uint8_t(0));
    if (frame.empty() || (isSigned && !m_signer->sign(frame)))
        return {};
    ++m_sequence;
    return frame;
}

} // namespace skyseal::mavlink
