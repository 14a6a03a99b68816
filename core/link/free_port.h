// Ports of 127.0.0.1 for programs that this one starts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace skyseal::link {

/// Different UDP ports of loopback that are free now, in random order. Nothing keeps them, but Linux gives none of them to a
/// socket that asks for any port, as it may do with a port that it has chosen itself, until the started program binds it.
std::vector<std::uint16_t> freeUdpPorts(std::size_t count);

} // namespace skyseal::link
