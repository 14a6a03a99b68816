// Sender of a frame, to address the answer.
#pragma once

#include <cstdint>

namespace skyseal::sim {

struct FrameSender
{
    std::uint8_t system = 0;
    std::uint8_t component = 0;
    int version = 2; ///< MAVLink version of the frame

    bool sameSender(const FrameSender &other) const { return system == other.system && component == other.component; }
};

} // namespace skyseal::sim
