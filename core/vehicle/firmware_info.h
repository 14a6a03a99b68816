// Firmware version and capabilities of the autopilot. Requests AUTOPILOT_VERSION until it arrives, alternating between the
// current command (MAV_CMD_REQUEST_MESSAGE) and the one of older firmware.
//
// Many autopilots that know MAVLink 2 send version 1 until they hear version 2 (ArduPilot before 4.2, PX4 with its former
// default MAV_PROTO_VER = 0), while the station speaks what it hears: both would stay with version 1 for ever. One that says it
// knows version 2 is therefore asked for its protocol version by a frame of version 2. If the autopilot and all links on the
// way understand it, its frames are of version 2 from then on; otherwise version 1 goes on undisturbed.
#pragma once

#include "core/vehicle/micro_protocol.h"

namespace skyseal::vehicle {

class FirmwareInfo : public MicroProtocol
{
public:
    static constexpr Duration kInterval = std::chrono::seconds(2);
    static constexpr int kAttempts = 6;
    static constexpr int kVersionAttempts = 3; ///< as often, since a frame may be lost

    using MicroProtocol::MicroProtocol;

    /// Requests it again from the first attempt on, over any link, since something that was asked for depends on it.
    void request(TimePoint now);

    bool handleFrame(TimePoint now, const mavlink::Frame &frame) override;
    void handleHeartbeat(TimePoint now) override;
    void handleDeadline(TimePoint now) override;
    TimePoint nextDeadline() const override { return std::min(nextRequest(), mayAsk() ? m_versionDue : kNever); }

private:
    TimePoint nextRequest() const { return mayAsk() || m_isNeeded ? m_next : kNever; }
    void askForVersion2(TimePoint now);

    bool m_isNeeded = false;
    TimePoint m_next = kNever;
    int m_attempts = 0;
    TimePoint m_versionDue = kNever;
    int m_versionAttempts = 0;
};

} // namespace skyseal::vehicle
