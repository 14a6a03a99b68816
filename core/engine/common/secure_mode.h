// The protection that the operator requires of received MAVLink.
#pragma once

#include <cstdint>

namespace skyseal::engine {

enum class SecureMode : std::uint8_t {
    Preferred, ///< sealed if the vehicle's agent is known; plain vehicles are shown as "not sealed", and while a known
               ///< agent has never connected only after the operator allowed them
    Required,  ///< clear MAVLink is never shown, except for recordings
    Off        ///< plain only: no handshake
};

} // namespace skyseal::engine
