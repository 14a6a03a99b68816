// The protection of MAVLink during a measurement, in place of the configured SecureMode and framing.
#pragma once

#include <cstdint>

namespace skyseal::engine {

enum class Protection : std::uint8_t {
    Plain,  ///< clear MAVLink and no handshake: the baseline; the agent must allow it
    Sealed, ///< whole frames in records, nothing in clear
    Inline  ///< frames sealed in place if the agent and the suite support it, nothing in clear
};

} // namespace skyseal::engine
