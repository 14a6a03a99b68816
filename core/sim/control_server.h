// The messages that steer without being commands: SET_MODE, position and velocity targets, stick overrides. None is
// answered; what is refused is said as text.
#pragma once

#include "core/mavlink/frame.h"
#include "core/sim/autopilot.h"

namespace skyseal::sim {

class ControlServer
{
public:
    explicit ControlServer(Autopilot &autopilot) : m_autopilot(autopilot) {}

    /// False when the message is none of these.
    bool handle(TimePoint now, const mavlink::Frame &frame);

private:
    void setMode(ByteView payload);
    void localTarget(ByteView payload);
    void globalTarget(ByteView payload);
    void overrideSticks(TimePoint now, ByteView payload);
    void manualControl(TimePoint now, ByteView payload);
    void face(std::uint16_t mask, double yaw, double offset);
    void report(const Autopilot::Refusal &refusal);

    Autopilot &m_autopilot;
};

} // namespace skyseal::sim
