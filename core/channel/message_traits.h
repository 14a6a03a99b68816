// The little that sealing a MAVLink frame in place needs to know of MAVLink. The channel carries opaque bytes otherwise and
// knows no message; whoever joins it with a dialect hands these facts in.
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
        std::int16_t targetSystemOffset = -1; ///< in the payload; -1: has none
        std::int16_t targetComponentOffset = -1;
    };

    virtual ~MessageTraits() = default;
    /// nullopt for a message that is not known: its checksum cannot be made, nor is it known where its targets stand.
    virtual std::optional<Message> message(std::uint32_t id) const = 0;
    /// MAVLink's checksum over a frame from its second byte to the end of its payload, and then CRC_EXTRA.
    virtual std::uint16_t checksum(ByteView bytes, std::uint8_t crcExtra) const = 0;
};

} // namespace skyseal::channel
