// A COMMAND_LONG to the autopilot of a vehicle.
#pragma once

#include "core/mavlink/messages.h"

#include <array>

namespace skyseal::test {

inline mavlink::CommandLong commandLong(std::uint16_t command, std::array<float, 7> p = {}, std::uint8_t system = 1)
{
    return {.target_system = system,
            .target_component = 1,
            .command = command,
            .param1 = p[0],
            .param2 = p[1],
            .param3 = p[2],
            .param4 = p[3],
            .param5 = p[4],
            .param6 = p[5],
            .param7 = p[6]};
}

} // namespace skyseal::test
