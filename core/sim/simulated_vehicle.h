// One simulated vehicle as seen from the other end of a link: frames and time go in, frames come out. Composes the autopilot
// and one server per MAVLink micro-protocol, and only routes between them.
//
// Sans-I/O. Input: handleFrame(), advance(). Output, after any input: pollFrame() until it is empty. Query: nextDeadline().
//
// Two clocks: link functions (heartbeats, streams, repetitions, loss of the station) run on the caller's clock; flight and
// time_boot_ms run SIM_SPEEDUP times as fast. A station can therefore speed a flight up without sending faster and without
// being considered lost.
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/frame.h"
#include "core/sim/autopilot.h"
#include "core/sim/link_trust.h"

#include <memory>

namespace skyseal::sim {

class MessageSigning;

struct SimulatedVehicleConfig
{
    std::uint8_t systemId = 1;
    AutopilotConfig autopilot;
    double rate = 1;     ///< flight seconds per second of the caller's clock
    WallTime bootTime{}; ///< wall time at construction, for SYSTEM_TIME
};

class SimulatedVehicle
{
public:
    SimulatedVehicle(const SimulatedVehicleConfig &config, TimePoint now);
    ~SimulatedVehicle();
    SimulatedVehicle(SimulatedVehicle &&) noexcept;
    SimulatedVehicle &operator=(SimulatedVehicle &&) noexcept;

    /// A received frame; frames for other targets are ignored, and while signing is on those that are not signed.
    void handleFrame(TimePoint now, const mavlink::Frame &frame, LinkTrust trust = LinkTrust::Ordinary);
    /// Advances to `now`. After a gap of more than a second, the telemetry of the gap is skipped.
    void advance(TimePoint now);
    TimePoint nextDeadline() const;

    /// Sends telemetry at once, in addition to the streams: `messages` common messages, then a TIMESYNC request whose ts1 is
    /// `ticket`. The answer of a station shows that all of them arrived.
    void sendBurst(TimePoint now, std::size_t messages, std::int64_t ticket);

    /// The same without a request: so many of the common messages, one after the other from the `first` on.
    void sendTelemetry(TimePoint now, std::uint64_t first, std::size_t messages);

    /// A heartbeat besides those that are due.
    void sendHeartbeat();

    /// The next frame to send, valid until the next call to this object; empty when there is none.
    ByteView pollFrame();
    /// Frames dropped because the outbox was full.
    std::uint64_t dropped() const;

    std::uint8_t systemId() const;
    const Autopilot &autopilot() const;
    /// For tests: the wind blows and parameters change without a radio.
    Autopilot &autopilot();

private:
    struct Parts;
    void setUpSigning(TimePoint now, const mavlink::Frame &frame);
    void reboot(TimePoint now);

    SimulatedVehicleConfig m_config;
    TimePoint m_boot;
    std::unique_ptr<MessageSigning> m_signing; ///< outlives a reboot
    std::unique_ptr<Parts> m_parts;
};

} // namespace skyseal::sim
