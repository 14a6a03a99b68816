// The first byte of every datagram of the protocol (PROTOCOL.md, section 2), and sizes common to its formats.
//
//   0 1 | version (2 bits) | kind (2 bits) | low (2 bits)        value 0x40-0x7F, MAVLink's magic bytes are 0xFD and 0xFE
//
// `low` is the epoch of a record and the number of the message within a handshake.
#pragma once

#include "core/base/bytes.h"
#include "core/base/path.h"

#include <cstddef>
#include <cstdint>

namespace skyseal::channel {

inline constexpr std::uint8_t kProtocolVersion = 1;

enum class DatagramKind : std::uint8_t {
    Record = 0,       ///< with a connection id, for carriers with several sessions (UDP, TUNNEL)
    SingleRecord = 1, ///< without connection id, on a serial carrier
    Handshake = 2,
    Pairing = 3
};

enum class HandshakeMessage : std::uint8_t { Announcement = 0, First = 1, Answer = 2, Cookie = 3 };

using skyseal::Carrier;

/// The end that sealed. Each direction has its own keys; the direction is also part of the associated data.
enum class Direction : std::uint8_t { FromInitiator = 0, FromResponder = 1 };

inline constexpr Direction opposite(Direction d)
{
    return d == Direction::FromInitiator ? Direction::FromResponder : Direction::FromInitiator;
}

/// Identifies a session to the receiver, which chooses it; the low byte is the slot of the receiver's session table.
enum class ConnectionId : std::uint16_t {};

inline constexpr std::size_t kMacLength = 16;
inline constexpr std::size_t kMaxDatagram = 1200;

constexpr std::uint8_t firstByte(DatagramKind kind, std::uint8_t low)
{
    return static_cast<std::uint8_t>(0x40 | kProtocolVersion << 4 | static_cast<std::uint8_t>(kind) << 2 | (low & 3));
}

constexpr std::uint8_t firstByte(HandshakeMessage message)
{
    return firstByte(DatagramKind::Handshake, static_cast<std::uint8_t>(message));
}

constexpr bool isOurs(std::uint8_t first)
{
    return (first & 0xc0) == 0x40;
}
constexpr std::uint8_t versionOf(std::uint8_t first)
{
    return first >> 4 & 3;
}
constexpr DatagramKind kindOf(std::uint8_t first)
{
    return static_cast<DatagramKind>(first >> 2 & 3);
}

} // namespace skyseal::channel
