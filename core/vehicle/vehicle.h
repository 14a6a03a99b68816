// One vehicle as a station sees it: frames go in, a VehicleState comes out, and every conversation with it (commands,
// parameters, missions, streams, time) is a small class of its own behind this one, which only routes.
//
// Sans-I/O. Query: state(), parameters(), mission(), nextDeadline(). Input: handleFrame(), handleDeadline(). Commands:
// command(), requestParameters(), writeParameter(), readMission(), writeMission(), clearMission(). After any input or
// command drain the output: pollOutgoing() first, then pollResult(), pollText(), pollMissionResult(), pollParameterResult().
#pragma once

#include "core/base/clock.h"
#include "core/mavlink/frame.h"
#include "core/vehicle/mission.h"
#include "core/vehicle/message_queue.h"
#include "core/vehicle/parameter.h"
#include "core/vehicle/transfer_result.h"
#include "core/vehicle/vehicle_command.h"
#include "core/vehicle/vehicle_config.h"
#include "core/vehicle/vehicle_state.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace skyseal::vehicle {

class Vehicle
{
public:
    /// `component` is the one whose heartbeat made the vehicle known; telemetry of others is not its state.
    Vehicle(const VehicleConfig &config, std::uint8_t systemId, std::uint8_t component);
    ~Vehicle();
    Vehicle(Vehicle &&) noexcept;
    Vehicle &operator=(Vehicle &&) noexcept;

    std::uint8_t systemId() const;
    /// A copy with the ages as of `now`. VehicleState::sequence stays zero: sequence numbers are counted per link, by the
    /// engine.
    VehicleState state(TimePoint now) const;
    /// The state without ages and texts copied; valid until the next call.
    const VehicleState &current() const;
    bool isLost(TimePoint now) const;

    /// All frames of the system id, whatever the component.
    void handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// Ends in exactly one CommandResult with this id.
    void command(TimePoint now, CommandId id, const VehicleCommand &command);
    void requestParameters(TimePoint now);
    void writeParameter(TimePoint now, std::string name, double value);
    void readMission(TimePoint now);
    void writeMission(TimePoint now, std::vector<MissionItem> items);
    void clearMission(TimePoint now);
    void setStreams(TimePoint now, StreamProfile profile, double rate = 0);

    std::optional<OutMessage> pollOutgoing();
    std::optional<CommandResult> pollResult();
    std::optional<StatusText> pollText();
    std::optional<MissionResult> pollMissionResult();
    std::optional<ParameterResult> pollParameterResult();

    /// Null until asked for; a new object only when something changed, so that it can be shared with snapshots.
    std::shared_ptr<const std::vector<Parameter>> parameters() const;
    std::uint32_t parametersExpected() const;
    /// As last read from or accepted by the vehicle; null before.
    std::shared_ptr<const std::vector<MissionItem>> mission() const;

private:
    struct Parts;
    std::unique_ptr<Parts> m_parts;
};

} // namespace skyseal::vehicle
