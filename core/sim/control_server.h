// Control messages other than commands: SET_MODE, position and velocity targets, stick overrides. They are not
// acknowledged; a refusal becomes a STATUSTEXT.
#pragma once

#include "core/mavlink/frame.h"
#include "core/sim/autopilot.h"

namespace skyseal::sim {

class ControlServer
{
public:
    explicit ControlServer(Autopilot &autopilot) : m_autopilot(autopilot) {}

    /// Returns false for other messages.
    bool handle(TimePoint now, const mavlink::Frame &frame);

private:
    void setMode(ByteView payload);
    void localTarget(ByteView payload);
    void globalTarget(ByteView payload);
    void overrideSticks(TimePoint now, ByteView payload);
    void manualControl(TimePoint now, ByteView payload);
    void face(std::uint16_t mask, double yaw, double offset);
    void report(const Refusal &refusal);

    Autopilot &m_autopilot;
};

} // namespace skyseal::sim
