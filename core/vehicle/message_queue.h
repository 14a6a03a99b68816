// Messages to one vehicle that wait to be framed. The engine gives each its sequence number, signs or seals it, and coalesces
// those that are not urgent.
#pragma once

#include "core/base/bytes.h"
#include "core/base/ring.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace skyseal::vehicle {

/// One message without its frame.
struct OutMessage
{
    std::uint32_t id = 0;                     ///< MAVLink message id
    std::uint8_t crcExtra = 0, minLength = 0; ///< of this message, for the frame
    std::uint8_t version = 0;                 ///< of its frame, 1 or 2; 0: as the vehicle is spoken to
    bool urgent = false;                      ///< flush at once: commands, mission items, heartbeats
    std::uint8_t size = 0;                    ///< bytes of the payload in use
    std::array<std::uint8_t, 255> payload{};  ///< zeros after `size`

    ByteView view() const { return {payload.data(), size}; }
};

/// A message that does not fit is refused. Every protocol repeats requests that were not answered, so a refusal counts as a
/// loss like any other.
using MessageQueue = Ring<OutMessage>;

} // namespace skyseal::vehicle
