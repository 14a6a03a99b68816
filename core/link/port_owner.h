// Finds the program that holds a port, for the error "in use". Best effort: Linux shows only programs of the same user.
#pragma once

#include <cstdint>
#include <string>

namespace skyseal::link {

enum class PortKind : std::uint8_t { Udp, Tcp };

/// Returns "skyseal (process 1234)", or an empty text when it cannot be found. Slow, since it reads /proc.
std::string portOwner(PortKind kind, std::uint16_t port);

} // namespace skyseal::link
