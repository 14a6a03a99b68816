// The inside of a Vehicle: its state, its clients, and the routing of frames to them. Included by vehicle.cpp and
// vehicle_parts.cpp alone.
#pragma once

#include "core/vehicle/autopilot_events.h"
#include "core/vehicle/commander.h"
#include "core/vehicle/firmware_info.h"
#include "core/vehicle/flight_timer.h"
#include "core/vehicle/ftp_client.h"
#include "core/vehicle/heartbeat_monitor.h"
#include "core/vehicle/home_tracker.h"
#include "core/vehicle/log_client.h"
#include "core/vehicle/mission_client.h"
#include "core/vehicle/mode_list.h"
#include "core/vehicle/parameter_client.h"
#include "core/vehicle/pre_arm_reasons.h"
#include "core/vehicle/protocol_version.h"
#include "core/vehicle/status_text_joiner.h"
#include "core/vehicle/stream_requester.h"
#include "core/vehicle/telemetry.h"
#include "core/vehicle/time_sync_client.h"
#include "core/vehicle/traffic.h"
#include "core/vehicle/unanswered_requests.h"
#include "core/vehicle/vehicle.h"

#include <deque>

namespace skyseal::vehicle {

struct Vehicle::Parts
{
    static constexpr std::size_t kMaxTexts = 200;

    Parts(const VehicleConfig &config, const Addressing &ends);

    void handleFrame(TimePoint now, WallTime wall, const mavlink::Frame &frame);
    void handleLateFrame(TimePoint now, const mavlink::Frame &frame);
    void handleDeadline(TimePoint now);
    TimePoint nextDeadline() const;

    /// Takes what belongs to the system rather than to its former autopilot, whose requests end as failed.
    void takeOver(Parts &former);

    VehicleContext context;
    mavlink::AutopilotClaim claim{}; ///< the greatest of the autopilot's heartbeats
    UnansweredRequests unanswered;
    std::deque<StatusText> texts; ///< the last kMaxTexts, for the state
    HeartbeatMonitor monitor;
    ProtocolVersion version;
    FlightTimer flightTimer;
    Traffic traffic;
    PreArmReasons preArm;
    AutopilotEvents events;

    // The clients, one row each. Every frame is offered to them in this order.
    StreamRequester streams;
    TimeSyncClient timeSync{context};
    FirmwareInfo firmware{context};
    ModeList modes;
    Commander commander{context};
    FtpClient files{context};
    ParameterClient parameters{context, files};
    MissionClient mission{context, firmware};
    LogClient logs{context};

private:
    bool offerToClients(TimePoint now, const mavlink::Frame &frame);
    void noteComponent(TimePoint now, const mavlink::Frame &heartbeat);
    void handleHeartbeat(TimePoint now, const mavlink::Heartbeat &m);
    void handleStatusText(TimePoint now, const mavlink::Frame &frame);
    void noteFlight(TimePoint now);
    void noteVerticalTakeOff();
    void handleTelemetry(TimePoint now, const mavlink::Frame &frame);
    void takeTexts(TimePoint now);
    void addText(TimePoint now, std::uint8_t component, std::uint8_t severity, std::string text);

    Telemetry telemetry;
    HomeTracker home;
    StatusTextJoiner joiner;
    std::uint64_t lastTextNumber = 0;
    WallTime lastWall{}; ///< of the last frame, for texts that a time-out completes
};

} // namespace skyseal::vehicle
