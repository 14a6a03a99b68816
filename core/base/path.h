// Where a datagram came from or goes to: one of our links, and the remote address on it. A plain value, so that no
// table grows with the number of (possibly forged) sources.
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

struct Path
{
    LinkId link{};
    Address remote;
    auto operator<=>(const Path &) const = default;
};

} // namespace skyseal
