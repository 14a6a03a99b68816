// Builds the telemetry messages about motion: attitude, position, velocity and the inertial sensors.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/frame_queue.h"

namespace skyseal::sim {

/// MAVLink's time_boot_ms.
inline std::uint32_t bootMilliseconds(const Autopilot &autopilot)
{
    return static_cast<std::uint32_t>(autopilot.time() / 1000);
}

class MotionMessages
{
public:
    /// `noise`: the noise of the sensors. All arguments must outlive this.
    MotionMessages(const Autopilot &autopilot, FrameQueue &outbox, Noise &noise)
        : m_autopilot(autopilot), m_outbox(outbox), m_noise(noise)
    {}

    /// Sends one message. Returns false if it is not about motion or its data is not available.
    bool send(std::uint32_t message);

private:
    void attitude();
    void globalPosition();
    void localPosition();
    bool positionTarget();
    bool localTarget();
    bool attitudeTarget();
    bool isPx4() const { return m_autopilot.flight().type.isPx4(); }
    void rawImu();
    void scaledImu();
    void pressure();
    void hud();
    void navigation();
    void vibration();

    /// Current readings of the inertial sensors, with noise.
    struct Inertial
    {
        Vector3 acceleration; ///< m/s², body axes
        Vector3 rates;        ///< rad/s, body axes
        Vector3 field;        ///< milligauss, body axes
    };
    Inertial inertial();
    template<typename Message> static void writeInertial(const Inertial &read, Message &out);
    GeoPoint place(const Vector3 &ned) const { return m_autopilot.flight().world.toGeo(ned); }

    const Autopilot &m_autopilot;
    FrameQueue &m_outbox;
    Noise &m_noise;
};

} // namespace skyseal::sim
