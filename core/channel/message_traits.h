// The properties of MAVLink messages that inline framing needs (PROTOCOL.md, section 12). The channel otherwise transports
// opaque bytes and knows no message; its owner implements this interface over a dialect.
#pragma once

#include "core/base/bytes.h"

#include <cstdint>
#include <optional>

namespace skyseal::channel {

class MessageTraits
{
public:
    struct Message
    {
        std::uint8_t crcExtra = 0;
        std::int16_t targetSystemOffset = -1; ///< in the payload; -1: none
        std::int16_t targetComponentOffset = -1;
    };

    virtual ~MessageTraits() = default;
    /// Returns nullopt for an unknown message: its CRC_EXTRA and the offsets of its targets are unknown.
    virtual std::optional<Message> message(std::uint32_t id) const = 0;
    /// MAVLink's checksum over `bytes` (a frame from its second byte to the end of its payload) and CRC_EXTRA.
    virtual std::uint16_t checksum(ByteView bytes, std::uint8_t crcExtra) const = 0;
};

} // namespace skyseal::channel
