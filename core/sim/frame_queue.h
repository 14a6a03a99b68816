// Frames that wait to be sent, encoded once, in a ring that is allocated once.
#pragma once

#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"

#include <vector>

namespace skyseal::sim {

class FrameQueue
{
public:
    explicit FrameQueue(std::uint8_t systemId, std::uint8_t componentId = mavlink::MAV_COMP_ID_AUTOPILOT1)
        : m_writer(systemId, componentId), m_slots(kSlots)
    {}

    /// Queues a message as a MAVLink 2 frame. When nobody fetched the last 256 frames, it is dropped and counted: a link
    /// that stalls loses telemetry, as a radio does.
    template<typename Message> void send(const Message &message)
    {
        if (m_count == kSlots) {
            ++m_dropped;
            return;
        }
        Slot &slot = m_slots[(m_first + m_count++) % kSlots];
        slot.size = m_writer.write(message, slot.bytes).size();
    }

    /// The oldest frame, valid until the next call to this object; empty when there is none.
    ByteView poll()
    {
        if (m_count == 0)
            return {};
        const Slot &slot = m_slots[m_first];
        m_first = (m_first + 1) % kSlots;
        --m_count;
        return {slot.bytes.data(), slot.size};
    }

    /// Queues what another outbox still holds, as it is: a reboot loses no answer that was given before.
    void takeOver(FrameQueue &other)
    {
        for (ByteView frame = other.poll(); !frame.empty() && m_count < kSlots; frame = other.poll()) {
            Slot &slot = m_slots[(m_first + m_count++) % kSlots];
            std::copy(frame.begin(), frame.end(), slot.bytes.begin());
            slot.size = frame.size();
        }
    }

    std::size_t room() const { return kSlots - m_count; }
    std::uint64_t dropped() const { return m_dropped; }

private:
    static constexpr std::size_t kSlots = 256;

    struct Slot
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> bytes;
        std::size_t size = 0;
    };

    mavlink::FrameWriter m_writer;
    std::vector<Slot> m_slots;
    std::size_t m_first = 0;
    std::size_t m_count = 0;
    std::uint64_t m_dropped = 0;
};

} // namespace skyseal::sim
