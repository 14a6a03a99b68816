// Where a message came from or goes to: one of our links, the remote address on it, and in what it travels there. A plain
// value, so that no table grows with the number of (possibly forged) sources.
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

/// What a message of the sealed channel travels in. It is authenticated, so that a record taken from one carrier is refused
/// on another.
enum class Carrier : std::uint8_t {
    Datagram = 1, ///< a datagram of its own
    Tunnel = 2,   ///< the MAVLink message TUNNEL, or a few of them
    Serial = 3    ///< a COBS frame within a stream of bytes
};

/// Who is meant behind a MAVLink router, where many share one address.
struct Node
{
    std::uint8_t system = 0; ///< 0: everybody, or there is no router
    std::uint8_t component = 0;
    auto operator<=>(const Node &) const = default;
};

struct Path
{
    LinkId link{};
    Address remote;
    Carrier carrier = Carrier::Datagram;
    Node node = {}; ///< in Carrier::Tunnel alone
    auto operator<=>(const Path &) const = default;

    /// The same link and address, whatever travels there.
    bool sharesPlace(const Path &other) const { return link == other.link && remote == other.remote; }
};

} // namespace skyseal
