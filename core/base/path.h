// The source or destination of a message: a link, the remote address on it, and the carrier. A plain value, so that no table
// grows with the number of (possibly forged) sources.
#pragma once

#include <array>
#include <compare>
#include <cstdint>

namespace skyseal {

/// A remote transport address: IPv6, or IPv4 mapped into it (::ffff:a.b.c.d). All zero on links with a single peer
/// (serial, log).
struct Address
{
    std::array<std::uint8_t, 16> ip{};
    std::uint16_t port = 0;
    auto operator<=>(const Address &) const = default;
};

/// Number of a link within one engine; never reused while the engine lives.
enum class LinkId : std::uint32_t {};

/// The carrier of a message of the sealed channel. It is authenticated: a record copied from one carrier to another is
/// rejected.
enum class Carrier : std::uint8_t {
    Datagram = 1, ///< one datagram
    Tunnel = 2,   ///< one or several MAVLink TUNNEL messages
    Serial = 3    ///< a COBS frame in a byte stream
};

/// The MAVLink ids of an endpoint behind a MAVLink router, where several share one address.
struct Node
{
    std::uint8_t system = 0; ///< 0: all systems, or no router
    std::uint8_t component = 0;
    auto operator<=>(const Node &) const = default;
};

struct Path
{
    LinkId link{};
    Address remote;
    Carrier carrier = Carrier::Datagram;
    Node node = {}; ///< only used with Carrier::Tunnel
    auto operator<=>(const Path &) const = default;

    /// True for the same link and address; carrier and node are ignored.
    bool sharesPlace(const Path &other) const { return link == other.link && remote == other.remote; }
};

} // namespace skyseal
