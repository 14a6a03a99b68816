// Messages that wait for the broker. A broker that is slow or away costs a fixed amount of memory: of each state only the
// newest one waits, and of events and frames a limited number. Drops are counted.
//
// No thread and no clock of its own; Publisher locks it.
#pragma once

#include "core/base/bytes.h"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

namespace skyseal::mqtt {

enum class Kind : std::uint8_t { State, Event, Raw };
inline constexpr std::size_t kKinds = 3;

struct OutgoingMessage
{
    Kind kind{};
    std::string topic;
    std::string payload;
};

class PublishQueue
{
public:
    /// States are of vehicles, of which there are 255, and of the gateway.
    static constexpr std::size_t kMostStates = 256;
    static constexpr std::size_t kMostEvents = 1000;
    /// Frames of one vehicle, which also become one message: at 10 kB/s those of 1.6 s.
    static constexpr std::size_t kMostRawBytes = 16 * 1024;

    /// Replaces the waiting state of the same topic.
    void putState(std::string topic, std::string payload);
    /// The oldest event is dropped if there are too many.
    void putEvent(std::string topic, std::string payload);
    /// All waiting frames of the vehicle are dropped if there is no room: the newest ones are worth most. Allocates once for
    /// each vehicle.
    void putRaw(std::uint8_t systemId, ByteView frame);

    /// The oldest event. Events are taken apart from the rest, since the broker has to confirm each.
    std::optional<OutgoingMessage> takeEvent();
    /// The state that waited the longest, then frames.
    std::optional<OutgoingMessage> takeOther();
    bool isEmpty() const { return m_states.empty() && m_events.empty() && m_rawWaiting == 0; }

    /// Messages that never reached the broker: states that a newer one replaced, events, and frames.
    std::uint64_t dropped(Kind kind) const { return m_dropped[static_cast<std::size_t>(kind)]; }

private:
    struct Raw
    {
        std::string bytes;
        std::uint64_t frames = 0;
    };

    std::uint64_t &dropCounter(Kind kind) { return m_dropped[static_cast<std::size_t>(kind)]; }

    std::deque<std::string> m_order; ///< topics of m_states, the oldest first
    std::map<std::string, std::string> m_states;
    std::deque<OutgoingMessage> m_events;
    std::array<Raw, 256> m_raw;   ///< by system id
    std::size_t m_rawWaiting = 0; ///< vehicles with frames
    std::uint8_t m_nextRaw = 0;   ///< vehicles take turns
    std::array<std::uint64_t, kKinds> m_dropped{};
};

} // namespace skyseal::mqtt
