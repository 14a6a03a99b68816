// How a link is to carry MAVLink while it is measured, in place of what the station's settings say.
#pragma once

#include <cstdint>

namespace skyseal::engine {

enum class Protection : std::uint8_t {
    Plain,  ///< clear MAVLink and no handshake: the baseline; the agent must have been told to allow it
    Sealed, ///< whole frames in records, nothing in clear
    Inline  ///< frames sealed in place where the agent and the suite can do it, nothing in clear
};

} // namespace skyseal::engine
