// How the autopilot regards the link on which a frame arrived.
#pragma once

#include <cstdint>

namespace skyseal::sim {

enum class LinkTrust : std::uint8_t {
    Ordinary,
    Trusted ///< unsigned frames are accepted in any case
};

} // namespace skyseal::sim
