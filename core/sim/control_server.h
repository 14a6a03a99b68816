// Control messages other than commands: SET_MODE, position and velocity targets, stick overrides. Only
// SET_MODE is acknowledged; a refusal becomes a STATUSTEXT.
#pragma once

#include "core/mavlink/frame.h"
#include "core/sim/autopilot.h"
#include "core/sim/frame_queue.h"

namespace skyseal::sim {

class ControlServer
{
public:
    ControlServer(Autopilot &autopilot, FrameQueue &outbox) : m_autopilot(autopilot), m_outbox(outbox) {}

    /// Returns false for other messages.
    bool handle(TimePoint now, const mavlink::Frame &frame);

private:
    void setMode(const mavlink::Frame &frame);
    void localTarget(ByteView payload);
    void globalTarget(ByteView payload);
    void overrideSticks(TimePoint now, ByteView payload);
    void manualControl(TimePoint now, ByteView payload);
    void face(std::uint16_t mask, double yaw, double offset);
    void report(const Refusal &refusal);

    Autopilot &m_autopilot;
    FrameQueue &m_outbox;
};

} // namespace skyseal::sim
