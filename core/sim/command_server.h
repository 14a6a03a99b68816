// Vehicle side of the command protocol (https://mavlink.io/en/services/command.html): every COMMAND_LONG and COMMAND_INT
// addressed to this vehicle gets exactly one COMMAND_ACK.
#pragma once

#include "core/sim/autopilot.h"
#include "core/sim/frame_queue.h"
#include "core/sim/frame_sender.h"
#include "core/sim/stream_scheduler.h"
#include "core/sim/telemetry_sender.h"

namespace skyseal::sim {

/// A command of either kind: places in degrees, so that both kinds are alike.
struct Command
{
    std::uint16_t id = 0;
    std::uint8_t frame = 0; ///< MAV_FRAME; of COMMAND_LONG the one that ArduPilot assumes for this command
    std::array<float, 4> parameters{};
    double x = 0; ///< latitude in degrees, or parameter 5
    double y = 0; ///< longitude in degrees, or parameter 6
    float z = 0;  ///< altitude, or parameter 7
};

class CommandServer
{
public:
    CommandServer(Autopilot &autopilot, StreamScheduler &streams, TelemetrySender &telemetry, FrameQueue &outbox)
        : m_autopilot(autopilot), m_streams(streams), m_telemetry(telemetry), m_outbox(outbox)
    {}

    void handle(TimePoint now, const FrameSender &peer, const Command &command);

    /// Returns true if a reboot was requested and accepted since the last call.
    bool takeReboot() { return std::exchange(m_reboot, false); }

    /// Place of a command or message, NED; nullopt if the coordinate frame or the place is unusable. Zero means the
    /// current place.
    static std::optional<Vector3> place(const Autopilot &autopilot, std::uint8_t frame, double latitude, double longitude,
                                        double altitude);

private:
    std::uint8_t execute(TimePoint now, const Command &command);
    std::uint8_t fly(const Command &command);
    std::uint8_t takeOff(const Command &command);
    /// UNSUPPORTED if the vehicle has no such mode.
    std::uint8_t enter(FlightMode mode);
    std::uint8_t arm(const Command &command);
    std::uint8_t setMode(const Command &command);
    std::uint8_t reposition(const Command &command);
    std::optional<Vector3> repositionTarget(const Command &command) const;
    std::uint8_t yaw(const Command &command);
    std::uint8_t pointAt(const Command &command);
    std::uint8_t changeSpeed(const Command &command);
    std::uint8_t setHome(const Command &command);
    std::uint8_t setCurrent(const Command &command);
    std::uint8_t enableFence(std::uint32_t what);
    std::uint8_t requestMessage(std::uint32_t message);
    std::uint8_t setInterval(TimePoint now, const Command &command);
    std::uint8_t getInterval(std::uint32_t message);
    std::uint8_t reboot(const Command &command);
    std::uint8_t answer(const Refusal &refusal);

    Autopilot &m_autopilot;
    StreamScheduler &m_streams;
    TelemetrySender &m_telemetry;
    FrameQueue &m_outbox;
    bool m_reboot = false;
};

} // namespace skyseal::sim
