// Which program holds a port, so that "in use" can name it. Best effort: Linux tells for programs of the same user.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::link {

enum class PortKind : std::uint8_t { Udp, Tcp };

/// "skyseal (process 1234)", or empty when the system does not tell. Reads /proc: for the moment of failure only.
std::string portOwner(PortKind kind, std::uint16_t port);

} // namespace skyseal::link
