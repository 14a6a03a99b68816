// What the operator asks of the link's security.
#pragma once

#include <cstdint>

namespace skyseal::engine {

enum class SecureMode : std::uint8_t {
    Preferred, ///< sealed where the vehicle's agent is known; plain vehicles are shown as "not sealed", where an
               ///< agent is still to be heard only after a person allowed them
    Required,  ///< clear MAVLink is never shown, but for recordings
    Off        ///< plain only: no handshake
};

} // namespace skyseal::engine
