// Finds the program that holds a port of this machine, for the error "in use" and for measurements beside it. Best effort:
// Linux shows only programs of the same user.
#pragma once

#include "core/base/path.h"

#include <cstdint>
#include <optional>
#include <string>

namespace skyseal::link {

enum class PortKind : std::uint8_t { Udp, Tcp };

struct PortOwner
{
    std::string name; ///< "skyseal"
    std::int64_t process = 0;
};

/// A TCP port has to be listened on. nullopt when the owner cannot be found. Slow, since it reads /proc.
std::optional<PortOwner> portOwner(PortKind kind, std::uint16_t port);
/// The program of this machine whose socket is connected to that port of this machine: of TCP, or of UDP if it has called
/// connect(). nullopt when there is none or it cannot be found. As slow.
std::optional<PortOwner> portCaller(PortKind kind, std::uint16_t port);
/// The program of this machine that sends datagrams from that address, also by a socket that is not connected. nullopt when the
/// address is none of this machine, or the program cannot be found. As slow.
std::optional<PortOwner> datagramSender(const Address &source);
/// "skyseal (process 1234)", or an empty text.
std::string portOwnerText(PortKind kind, std::uint16_t port);

} // namespace skyseal::link
