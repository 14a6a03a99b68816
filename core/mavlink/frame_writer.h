// Writes messages as frames of one sender.
#pragma once

#include "core/mavlink/frame.h"

#include <array>

namespace skyseal::mavlink {

/// Writes one frame into `out` and returns its bytes; empty if they do not fit (kMaxFrameLength always suffices).
/// `payload` is the whole payload; for MAVLink 2 its trailing zeros are cut, down to one byte; for MAVLink 1 it is cut to
/// `minLength`. With kFlagSigned in `incompatFlags` room for the signature is part of the frame, for signFrame() to fill.
MutableByteView writeFrame(MutableByteView out, int version, std::uint8_t sequence, std::uint8_t systemId,
                           std::uint8_t componentId, std::uint32_t messageId, std::uint8_t crcExtra, std::uint8_t minLength,
                           ByteView payload, std::uint8_t incompatFlags = 0);

class FrameSigner;

/// A sender: its ids, its protocol version and its running sequence number.
class FrameWriter
{
public:
    FrameWriter(std::uint8_t systemId, std::uint8_t componentId, int version = 2)
        : m_systemId(systemId), m_componentId(componentId), m_version(version)
    {}

    void setVersion(int version) { m_version = version; }
    int version() const { return m_version; }
    /// Signs every MAVLink 2 frame from now on; null = no more. The signer belongs to the caller, must outlive this use, and
    /// its time is advanced by the caller.
    void setSigner(FrameSigner *signer) { m_signer = signer; }

    /// A typed message (messages.h).
    template<typename Message> MutableByteView write(const Message &message, MutableByteView out)
    {
        std::array<std::uint8_t, Message::kMaxLength> payload;
        message.encode(payload);
        return write(Message::kId, Message::kCrcExtra, Message::kMinLength, payload, out);
    }

    /// Any message, with an encoded payload.
    MutableByteView write(std::uint32_t messageId, std::uint8_t crcExtra, std::uint8_t minLength, ByteView payload,
                          MutableByteView out);

private:
    std::uint8_t m_systemId;
    std::uint8_t m_componentId;
    std::uint8_t m_sequence = 0;
    int m_version;
    FrameSigner *m_signer = nullptr;
};

} // namespace skyseal::mavlink
