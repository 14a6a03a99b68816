// What a vehicle's protocols want sent, before it becomes frames: the engine gives each message its sequence number, signs
// or seals it, and coalesces those that are not urgent. Bounded, so that a silent link can not make it grow.
#pragma once

#include "core/base/bytes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

/// One message without its frame.
struct OutMessage
{
    std::uint32_t id = 0;                     ///< MAVLink message id
    std::uint8_t crcExtra = 0, minLength = 0; ///< of this message, for the frame
    bool urgent = false;                      ///< flush at once: commands, mission items, heartbeats
    std::uint8_t size = 0;                    ///< bytes of the payload in use
    std::array<std::uint8_t, 255> payload{};  ///< zeros behind `size`

    ByteView view() const { return {payload.data(), size}; }
};

/// A ring of messages that is allocated once. When it is full a message is refused and counted; every protocol that writes
/// here repeats what was not answered, so a refusal is a loss like any other.
class MessageQueue
{
public:
    explicit MessageQueue(std::size_t capacity = 64) : m_ring(capacity) {}

    bool push(const OutMessage &message);
    std::optional<OutMessage> poll();

    bool empty() const { return m_count == 0; }
    std::size_t size() const { return m_count; }
    bool full() const { return m_count == m_ring.size(); }
    std::uint64_t refused() const { return m_refused; }

private:
    std::vector<OutMessage> m_ring;
    std::size_t m_first = 0;
    std::size_t m_count = 0;
    std::uint64_t m_refused = 0;
};

} // namespace skyseal::vehicle
