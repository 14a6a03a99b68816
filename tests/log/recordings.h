// Frames and recordings for the tests.
#pragma once

#include "core/log/tlog_entry.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <string>

namespace skyseal::tlog {

inline constexpr WallTime kNoon{std::chrono::microseconds(1'700'000'000'000'000)};

/// A HEARTBEAT that carries its number.
inline std::string heartbeat(std::uint32_t number, std::uint8_t systemId = 1)
{
    mavlink::FrameWriter writer(systemId, 1);
    mavlink::Heartbeat message;
    message.custom_mode = number;
    message.type = mavlink::MAV_TYPE_QUADROTOR;
    message.mavlink_version = 3;
    std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
    return std::string(asText(writer.write(message, buffer)));
}

inline std::string entry(WallTime time, const std::string &frame)
{
    std::array<std::uint8_t, mavlink::kMaxFrameLength + kTimeLength> buffer;
    return std::string(asText(writeEntry(buffer, time, asBytes(frame))));
}

inline std::uint32_t numberOf(const mavlink::Frame &frame)
{
    return mavlink::Heartbeat::decode(frame.payload()).custom_mode;
}

} // namespace skyseal::tlog
