// The two roles of an endpoint (PROTOCOL.md, section 1).
#pragma once

#include <cstdint>

namespace skyseal::channel {

/// The station listens, learns an agent's address from its announcements and starts the handshake (Noise initiator). The
/// agent announces itself until a session is up (Noise responder).
enum class Role : std::uint8_t { Station, Agent };

} // namespace skyseal::channel
