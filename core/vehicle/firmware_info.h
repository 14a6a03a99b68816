// Firmware version and capabilities of the autopilot. Requests AUTOPILOT_VERSION until it arrives, alternating between the
// current command (MAV_CMD_REQUEST_MESSAGE) and the one of older firmware.
#pragma once

#include "core/vehicle/micro_protocol.h"

namespace skyseal::vehicle {

class FirmwareInfo : public MicroProtocol
{
public:
    static constexpr Duration kInterval = std::chrono::seconds(2);
    static constexpr int kAttempts = 6;

    using MicroProtocol::MicroProtocol;

    /// Requests it again from the first attempt on, over any link, since something that was asked for depends on it.
    void request(TimePoint now);

    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return mayAsk() || m_isNeeded ? m_next : kNever; }

private:
    bool m_isNeeded = false;
    TimePoint m_next = kNever;
    int m_attempts = 0;
};

} // namespace skyseal::vehicle
