// One vehicle as a station sees it: frames go in, a VehicleState comes out. Each MAVLink micro-protocol (commands, parameters,
// missions, streams, time) has a client class of its own behind this one, which only routes.
//
// Sans-I/O. Query: state(), parameters(), mission(), fence(), rally(), nextDeadline(). Input: handleFrame(), handleDeadline().
// Commands: perform(), setStreams(). After any input or command drain the output: pollOutgoing() first, then pollEvent().
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/autopilot_heartbeat.h"
#include "core/mavlink/frame.h"
#include "core/vehicle/event.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/request.h"
#include "core/vehicle/vehicle_config.h"
#include "core/vehicle/vehicle_state.h"

#include <memory>
#include <optional>
#include <vector>

namespace skyseal::vehicle {

class Vehicle
{
public:
    static constexpr std::size_t kMostComponents = 32; ///< that are listed beside the autopilot

    /// `component` is the autopilot, whose heartbeat announced the vehicle; telemetry of other components is ignored.
    Vehicle(const VehicleConfig &config, std::uint8_t systemId, std::uint8_t component);
    ~Vehicle();
    Vehicle(Vehicle &&) noexcept;
    Vehicle &operator=(Vehicle &&) noexcept;

    std::uint8_t systemId() const;
    std::uint8_t componentId() const; ///< of the autopilot
    /// A copy with the ages as of `now`. VehicleState::sequence stays zero, since the engine counts sequence numbers per link.
    VehicleState state(TimePoint now) const;
    /// The state with neither ages nor texts, without a copy; valid until the next call.
    const VehicleState &current() const;
    bool isLost(TimePoint now) const;

    /// How much has spoken for the present component being the autopilot, by its heartbeats.
    mavlink::AutopilotClaim claim() const;
    /// Another component is the autopilot: its state begins anew, and requests to the former one end as failed. The texts and
    /// the other components of the system remain.
    void replaceAutopilot(const VehicleConfig &config, std::uint8_t component);

    /// All frames of the system id, of any component. `wall` becomes the time of status texts.
    void handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    /// A frame that newer ones of its kind have overtaken, or that was delayed on its way: it can answer a request or bring a
    /// text, but changes no present value and is no sign of life.
    void handleLateFrame(TimePoint now, const mavlink::Frame &frame);
    /// The state of the radio over which the vehicle is heard.
    void handleRadioStatus(const mavlink::RadioStatus &status);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// Starts a request; its result arrives as an event with this id. Every request but
    /// CancelTransfer ends in exactly one result; a read of the list of parameters that another one replaced ends in none.
    void perform(TimePoint now, RequestId id, const Request &request);
    /// `rate` in Hz replaces the rates of the profile; 0 = the profile's.
    void setStreams(TimePoint now, StreamProfile profile, double rate = 0);

    /// The next message to send, valid until the next call; null when there is none.
    const OutMessage *pollOutgoing();
    std::optional<Event> pollEvent();

    /// Null before ReadParameters; a new object after every change, so that snapshots can share it.
    std::shared_ptr<const std::vector<Parameter>> parameters() const;
    std::uint32_t parametersExpected() const;
    /// As last read, or as accepted by the vehicle; null before.
    MissionItems mission() const;
    MissionItems fence() const;
    MissionItems rally() const;
    /// Why the vehicle may have another list by now than the one above; empty while there is no sign of it.
    const Reason &outdated(MissionType type) const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace skyseal::vehicle
