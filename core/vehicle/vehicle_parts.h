// The inside of a Vehicle: its state, its conversations, and the routing of messages between them. Only vehicle.cpp and
// vehicle_parts.cpp include this.
#pragma once

#include "core/vehicle/commander.h"
#include "core/vehicle/firmware_info.h"
#include "core/vehicle/flight_timer.h"
#include "core/vehicle/heartbeat_monitor.h"
#include "core/vehicle/home_tracker.h"
#include "core/vehicle/mission_client.h"
#include "core/vehicle/parameter_client.h"
#include "core/vehicle/status_text_joiner.h"
#include "core/vehicle/stream_requester.h"
#include "core/vehicle/telemetry.h"
#include "core/vehicle/time_sync_client.h"
#include "core/vehicle/vehicle.h"

#include <deque>

namespace skyseal::vehicle {

struct Vehicle::Parts
{
    static constexpr std::size_t kMostTexts = 200;

    Parts(const VehicleConfig &config, const Addressing &ends);

    void handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    void takeTexts(TimePoint now, WallTime wall);

    Addressing addressing;
    VehicleState state;
    std::deque<StatusText> texts;  ///< the last ones, for the state
    std::deque<StatusText> unread; ///< for pollText()
    std::uint64_t lastTextNumber = 0;
    WallTime lastWall{}; ///< of the last frame, for texts that a time-out completes
    MessageQueue outbox;
    Telemetry telemetry;
    HeartbeatMonitor monitor;
    StatusTextJoiner joiner;
    StreamRequester streams;
    TimeSyncClient timeSync;
    FirmwareInfo firmware;
    HomeTracker home;
    FlightTimer flightTimer;
    Commander commander;
    ParameterClient parameters;
    MissionClient mission;

private:
    /// A message that is part of a conversation rather than telemetry. True when it was.
    bool handleConversation(TimePoint now, const mavlink::Frame &frame);
    void handleHeartbeat(TimePoint now, const mavlink::Frame &frame);
    void handleStatusText(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    void handleAck(TimePoint now, const mavlink::Frame &frame);
    void handleVersion(const mavlink::Frame &frame);
    void handleParameter(TimePoint now, const mavlink::Frame &frame);
    void handleMission(TimePoint now, const mavlink::Frame &frame);
    void takeStatus(TimePoint now, const TelemetryNews &news);
};

} // namespace skyseal::vehicle
