// The properties of MAVLink messages that the channel needs to seal frames in place, read from a dialect.
#pragma once

#include "core/channel/message_traits.h"
#include "core/mavlink/crc.h"
#include "core/mavlink/dialect.h"

namespace skyseal::engine {

class DialectTraits final : public channel::MessageTraits
{
public:
    /// `dialect` must outlive this object.
    explicit DialectTraits(const mavlink::Dialect &dialect) : m_dialect(&dialect) {}

    std::optional<Message> message(std::uint32_t id) const override
    {
        const mavlink::MessageInfo *info = m_dialect->find(id);
        if (!info)
            return std::nullopt;
        return Message{info->crcExtra, info->targetSystemOffset, info->targetComponentOffset};
    }

    std::uint16_t checksum(ByteView bytes, std::uint8_t crcExtra) const override
    {
        return mavlink::crcAccumulate(mavlink::crcAccumulate(mavlink::kCrcStart, bytes), {&crcExtra, 1});
    }

private:
    const mavlink::Dialect *m_dialect;
};

} // namespace skyseal::engine
