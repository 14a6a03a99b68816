// Lines of JSON for scripts: one object for each event, and the statistics of every second. The station's monitor and the
// agent write the same shapes and names, which are part of the programs' interface.
#pragma once

#include "core/base/json_writer.h"
#include "core/engine/station/event.h"
#include "core/engine/station/snapshot.h"
#include "core/vehicle/flight_script_runner.h"

#include <string>

namespace skyseal::engine {

/// `side` is "vehicle" or "ground" where a program has two; empty otherwise.
std::string linkEvent(const LinkSnapshot &link, std::string_view side = {});
std::string sessionUpEvent(const channel::SessionUp &up, const std::string &remoteAddress);
std::string sessionDownEvent(const channel::SessionDown &down, const std::string &peer);
/// A switch of suites, or of keys alone ("rekey").
std::string switchEvent(const channel::SwitchDone &done);
std::string vehicleEvent(const VehicleFound &found);
std::string vehicleLostEvent(std::uint8_t systemId, bool lost);
std::string statusTextEvent(const vehicle::TextReceived &text);
std::string peerMovedEvent(const std::string &peer, const std::string &from, const std::string &to);
std::string refusedEvent(const channel::HandshakeRefused &refused, const std::string &remoteAddress,
                         const std::string &fingerprint);
std::string forgeryEvent(const channel::ForgeryAlarm &alarm);
std::string commandsLateEvent(const channel::CommandsLate &late, const std::string &peer);
std::string unansweringEvent(const AgentUnanswering &event);
std::string plaintextEvent(const PlaintextRefused &refused);
std::string systemRefusedEvent(const SystemRefused &refused);
/// One step of a flight script.
std::string commandEvent(const vehicle::StepReport &report);
std::string recordingEvent(const RecordingProblem &problem);

/// Parts of "stats" and "summary".
void writeMavlink(JsonWriter &json, const MavlinkTotals &totals);
void writeChannel(JsonWriter &json, const ChannelTotals &totals);
void writeProcess(JsonWriter &json, double cpuPercent, std::uint64_t residentBytes);

/// `event` is "stats" or "summary"; `time` is seconds since the start.
std::string statsEvent(std::string_view event, const Snapshot &snapshot, double time);

} // namespace skyseal::engine
