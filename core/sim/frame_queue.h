// Encoded frames of one vehicle that wait to be sent.
#pragma once

#include "core/base/ring.h"
#include "core/mavlink/enums.h"
#include "core/mavlink/frame_writer.h"

namespace skyseal::sim {

class FrameQueue
{
public:
    static constexpr std::size_t kCapacity = 256;
    /// Frames of room that lists, bursts and logs leave.
    static constexpr std::size_t kKeptForTelemetry = 32;

    explicit FrameQueue(std::uint8_t systemId, std::uint8_t componentId = mavlink::MAV_COMP_ID_AUTOPILOT1)
        : m_writer(systemId, componentId), m_frames(kCapacity)
    {}

    /// Null: frames are not signed. Otherwise it must outlive its use.
    void setSigner(mavlink::FrameSigner *signer) { m_writer.setSigner(signer); }

    /// Queues a message as a MAVLink 2 frame. A full queue drops and counts it: a link that stalls loses telemetry, as a
    /// radio does.
    template<typename Message> void send(const Message &message)
    {
        if (EncodedFrame *frame = m_frames.append())
            frame->size = m_writer.write(message, frame->bytes).size();
    }

    /// Removes the oldest frame; valid until the next send(). Empty if there is none.
    ByteView poll()
    {
        const EncodedFrame *frame = m_frames.take();
        return frame ? ByteView(frame->bytes).first(frame->size) : ByteView();
    }

    /// Moves the frames of another queue here unchanged, so that a reboot loses no answer that is already queued.
    void takeOver(FrameQueue &other)
    {
        while (!m_frames.full()) {
            const EncodedFrame *frame = other.m_frames.take();
            if (!frame)
                return;
            m_frames.push(*frame);
        }
    }

    std::size_t room() const { return m_frames.room(); }
    std::uint64_t dropped() const { return m_frames.refused(); }

private:
    struct EncodedFrame
    {
        std::array<std::uint8_t, mavlink::kMaxFrameLength> bytes;
        std::size_t size = 0;
    };

    mavlink::FrameWriter m_writer;
    Ring<EncodedFrame> m_frames;
};

} // namespace skyseal::sim
