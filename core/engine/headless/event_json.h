// The JSON of the station's monitor beyond common_json.h: one object a line for vehicles, refusals and script steps, and the
// statistics of every second. Names and shapes are part of the programs' interface.
#pragma once

#include "core/engine/headless/common_json.h"
#include "core/engine/station/event.h"
#include "core/vehicle/flight_script_runner.h"

#include <string>

namespace skyseal::engine {

struct Snapshot;

std::string vehicleEvent(const VehicleFound &found);
std::string vehicleLostEvent(std::uint8_t systemId, bool lost);
std::string statusTextEvent(const vehicle::TextReceived &text);
std::string unansweringEvent(const AgentUnanswering &event);
std::string plaintextEvent(const PlaintextRefused &refused);
std::string systemRefusedEvent(const SystemRefused &refused);
/// One step of a flight script.
std::string commandEvent(const vehicle::StepReport &report);
/// Events that are missing before this line, because the reader of the output did not keep up.
std::string eventsDroppedEvent(const EventsDropped &dropped);
std::string recordingEvent(const RecordingProblem &problem);
std::string servedLinkEvent(const ServedLinkChanged &served);
std::string clientEvent(const ClientConnected &client);
std::string clientEvent(const ClientGone &client);
std::string clientDeniedEvent(const ClientDenied &denied);

/// The state at this moment: the statistics, and the sessions.
std::string statusEvent(const Snapshot &snapshot);
/// `event` is "stats" or "summary"; `time` is seconds since the start.
std::string statsEvent(std::string_view event, const Snapshot &snapshot, double time);

} // namespace skyseal::engine
