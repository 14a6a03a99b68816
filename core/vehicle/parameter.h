// One onboard parameter.
#pragma once

#include "core/mavlink/enums.h"

#include <cstdint>
#include <string>

namespace skyseal::vehicle {

struct Parameter
{
    std::string name;                                   ///< up to 16 characters
    double value = 0;                                   ///< ArduPilot's are floats on the wire whatever their type
    std::uint8_t type = mavlink::MAV_PARAM_TYPE_REAL32; ///< MAV_PARAM_TYPE
    std::uint16_t index = 0;
};

} // namespace skyseal::vehicle
