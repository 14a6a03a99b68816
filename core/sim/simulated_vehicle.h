// One simulated vehicle as the other end of a link sees it: frames and time go in, frames come out. Composes the autopilot
// and one server per MAVLink micro-protocol, and only routes between them.
//
// Sans-I/O. Input: handleFrame(), advance(). Output, after any input: pollFrame() until it is empty. Query: nextDeadline().
//
// Two times: what belongs to the link (heartbeats, streams, repetitions, the station's silence) runs on the caller's clock;
// flying runs SIM_SPEEDUP times as fast, and so does time_boot_ms. A station can therefore speed a flight up without
// having to speak faster, and without being taken for lost.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/frame.h"
#include "core/sim/autopilot.h"

#include <memory>

namespace skyseal::sim {

struct VehicleConfig
{
    std::uint8_t systemId = 1;
    AutopilotConfig autopilot;
    double rate = 1;     ///< flight seconds per second of the caller's clock
    WallTime bootTime{}; ///< wall time at construction, for SYSTEM_TIME
};

class SimulatedVehicle
{
public:
    SimulatedVehicle(const VehicleConfig &config, TimePoint now);
    ~SimulatedVehicle();
    SimulatedVehicle(SimulatedVehicle &&) noexcept;
    SimulatedVehicle &operator=(SimulatedVehicle &&) noexcept;

    /// A frame that arrived; what is not meant for this vehicle is ignored.
    void handleFrame(TimePoint now, const mavlink::Frame &frame);
    /// Lives on until `now`. After a stop of more than a second, the telemetry of the gap is left out.
    void advance(TimePoint now);
    TimePoint nextDeadline() const;

    /// Telemetry at once, beside the streams: so many messages of the usual kinds, and behind them a TIMESYNC request whose
    /// ts1 is `ticket`. A station's answer says that it has all of them.
    void sendBurst(TimePoint now, std::size_t messages, std::int64_t ticket);

    /// The next frame to send, valid until the next call to this object; empty when there is none.
    ByteView pollFrame();
    /// Frames that nobody fetched in time.
    std::uint64_t dropped() const;

    std::uint8_t systemId() const;
    const Autopilot &autopilot() const;
    /// For tests: the wind blows and parameters change without a radio.
    Autopilot &autopilot();

private:
    struct Parts;
    void reboot(TimePoint now);

    VehicleConfig m_config;
    TimePoint m_boot;
    std::unique_ptr<Parts> m_parts;
};

} // namespace skyseal::sim
