// Frames that stations send to the vehicle of an agent that is fuzzed.
#pragma once

#include "core/base/byte_reader.h"
#include "core/mavlink/dialect.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"
#include "core/mavlink/messages.h"

#include <array>

namespace skyseal::test {

class GroundFrames
{
public:
    /// An arming command, a question, or any message of the dialect, to the vehicle. Each has another number within, as far as
    /// its payload has room.
    Bytes make(std::uint8_t kind, ByteReader &in)
    {
        const auto number = static_cast<std::uint32_t>(++m_number);
        std::array<std::uint8_t, mavlink::kMaxFrameLength> buffer;
        mavlink::CommandLong command;
        command.command = kind == 0 ? mavlink::MAV_CMD_COMPONENT_ARM_DISARM : mavlink::MAV_CMD_REQUEST_MESSAGE;
        command.param1 = kind == 0 ? 1 : static_cast<float>(number);
        command.param5 = kind == 0 ? static_cast<float>(number) : 0;
        command.target_system = 1;
        command.target_component = 1;
        ByteView out;
        if (kind < 2) {
            out = m_writer.write(command, buffer);
        } else {
            const auto messages = mavlink::Dialect::builtin().messages();
            const mavlink::MessageInfo &info = messages[((kind - 2u) * 256u + in.u8()) % messages.size()];
            std::array<std::uint8_t, 255> payload{};
            for (std::size_t i = 0; i < 4; ++i)
                payload[i] = static_cast<std::uint8_t>(number >> 8 * i);
            for (const std::int16_t target : {info.targetSystemOffset, info.targetComponentOffset}) {
                if (target >= 0)
                    payload[static_cast<std::size_t>(target)] = 1;
            }
            out = m_writer.write(info.id, info.crcExtra, info.minLength, ByteView(payload).first(info.maxLength), buffer);
        }
        return Bytes(out.begin(), out.end());
    }

private:
    mavlink::FrameWriter m_writer{255, 190};
    std::size_t m_number = 0;
};

} // namespace skyseal::test
