// Conversion between frames, typed messages and queued messages.
#pragma once

#include "core/mavlink/frame.h"
#include "core/mavlink/messages.h"
#include "core/vehicle/message_queue.h"

namespace skyseal::vehicle {

template<typename Message> Message unpack(const mavlink::Frame &frame)
{
    return Message::decode(frame.payload());
}

template<typename Message> OutMessage pack(const Message &message, bool urgent = false)
{
    OutMessage out;
    out.id = Message::kId;
    out.crcExtra = Message::kCrcExtra;
    out.minLength = Message::kMinLength;
    out.urgent = urgent;
    out.size = Message::kMaxLength;
    message.encode(std::span<std::uint8_t, Message::kMaxLength>(out.payload.data(), Message::kMaxLength));
    return out;
}

} // namespace skyseal::vehicle
