// The JSON of the station's monitor beyond common_json.h: one object a line for vehicles, refusals and script steps, and the
// statistics of every second. Names and shapes are part of the programs' interface.
#pragma once

#include "core/engine/common/peer_names.h"
#include "core/engine/headless/common_json.h"
#include "core/engine/station/event.h"
#include "core/mqtt/publisher_status.h"
#include "core/vehicle/flight_script_runner.h"

#include <string>

namespace skyseal::engine {

struct Snapshot;
struct VehicleSnapshot;

/// The line of any event; empty for events that are not reported to scripts. `names` must have noted the event.
std::string eventJson(const Event &event, const PeerNames &names);

std::string vehicleEvent(const VehicleFound &found);
std::string vehicleLostEvent(std::uint8_t systemId, bool lost);
std::string statusTextEvent(const vehicle::TextReceived &text);
std::string unansweringEvent(const AgentUnanswering &event);
std::string plaintextEvent(const PlaintextRefused &refused);
std::string systemRefusedEvent(const SystemRefused &refused);
std::string otherSystemsEvent(const OtherSystemsHeard &heard);
std::string ownIdEvent(const OwnIdClaimed &claim);
/// One step of a flight script.
std::string commandEvent(const vehicle::StepReport &report);
/// Number of events that were dropped before this line, because the reader of the output did not keep up.
std::string eventsDroppedEvent(const EventsDropped &dropped);
std::string recordingEvent(const RecordingProblem &problem);
std::string servedLinkEvent(const ServedLinkChanged &served);
std::string clientEvent(const ClientConnected &client);
std::string clientEvent(const ClientGone &client);
std::string clientDeniedEvent(const ClientDenied &denied);

/// The connection to the MQTT broker was established or lost.
std::string brokerEvent(const std::string &url, const mqtt::PublisherStatus &broker);

/// The state of one vehicle of the snapshot, and how it is connected. `now`: the time of the snapshot.
std::string vehicleStateEvent(const Snapshot &snapshot, const VehicleSnapshot &vehicle, WallTime now);
/// The present state: the statistics, and the sessions.
std::string statusEvent(const Snapshot &snapshot);
/// `event` is "stats" or "summary"; `time` is seconds since the start.
std::string statsEvent(std::string_view event, const Snapshot &snapshot, double time);

} // namespace skyseal::engine
