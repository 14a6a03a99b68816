// Builds each telemetry message from the autopilot's state, in MAVLink's units.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/frame_queue.h"

namespace skyseal::sim {

class Telemetry
{
public:
    /// `seed` gives the sensors' noise and the board's serial number.
    Telemetry(const Autopilot &autopilot, FrameQueue &outbox, std::uint64_t seed);

    /// Wall time at the next messages, for SYSTEM_TIME.
    void setWallTime(WallTime time) { m_wallTime = time; }

    /// Sends one message. Returns false if it is unknown or its data is not available.
    bool send(std::uint32_t message);
    void sendText(const StatusText &text);

private:
    bool sendMotion(std::uint32_t message);
    bool sendSystem(std::uint32_t message);

    void heartbeat();
    void systemStatus();
    void batteryStatus();
    void gpsRaw();
    void rawImu();
    void scaledImu();
    void pressure();
    void attitude();
    void globalPosition();
    bool positionTarget();
    void navigation();
    void servos();
    void radioChannels();
    void hud();
    void vibration();
    bool homePosition();
    void extendedState();
    void version();

    /// Current readings of the inertial sensors, with noise.
    struct Inertial
    {
        Vector3 acceleration; ///< m/s², body axes
        Vector3 rates;        ///< rad/s, body axes
        Vector3 field;        ///< milligauss, body axes
    };
    Inertial inertial();
    template<typename Message> static void writeInertial(const Inertial &read, Message &out);
    std::uint32_t bootMilliseconds() const { return static_cast<std::uint32_t>(m_autopilot.time() / 1000); }
    GeoPoint place(const Vector3 &ned) const { return m_autopilot.world().toGeo(ned); }

    const Autopilot &m_autopilot;
    FrameQueue &m_outbox;
    Noise m_noise;
    std::uint64_t m_serial;
    WallTime m_wallTime{};
    std::uint16_t m_textId = 0;
};

} // namespace skyseal::sim
