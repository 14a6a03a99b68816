// Sends telemetry messages that it builds from the state of the autopilot, in MAVLink's units: here those about health, power,
// radio and identity; MotionMessages has the others.
#pragma once

#include "core/sim/air_traffic.h"
#include "core/sim/autopilot.h"
#include "core/sim/motion_messages.h"

namespace skyseal::sim {

class TelemetrySender
{
public:
    /// `seed` gives the sensors' noise and the board's serial number.
    TelemetrySender(const Autopilot &autopilot, FrameQueue &outbox, std::uint64_t seed);
    TelemetrySender(const TelemetrySender &) = delete;
    TelemetrySender &operator=(const TelemetrySender &) = delete;

    /// Wall time at the next messages, for SYSTEM_TIME.
    void setWallTime(WallTime time) { m_wallTime = time; }

    /// Sends one message. Returns false if it is unknown or its data is not available.
    bool send(std::uint32_t message);
    void sendText(const PendingText &text);

private:
    bool sendSystem(std::uint32_t message);

    void heartbeat();
    void systemStatus();
    void batteryStatus();
    void gpsRaw();
    void servos();
    void radioChannels();
    bool homePosition();
    void extendedState();
    bool fenceStatus();
    void version();
    bool aircraft();
    void estimatorStatus();
    std::uint8_t baseMode() const;

    GeoPoint place(const Vector3 &ned) const { return m_autopilot.flight().world.toGeo(ned); }

    const Autopilot &m_autopilot;
    FrameQueue &m_outbox;
    Noise m_noise;
    std::uint64_t m_serial;
    MotionMessages m_motion;
    AirTraffic m_traffic;
    WallTime m_wallTime{};
    std::uint16_t m_textId = 0;
};

} // namespace skyseal::sim
