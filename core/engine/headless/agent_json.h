// The agent's statistics and refusals as lines of JSON for scripts; its other events have the shapes of common_json.h.
#pragma once

#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"

#include <string>

namespace skyseal::engine {

/// {"event":"frames_refused"}: frames of an authenticated peer that were not forwarded to the vehicle.
std::string framesRefusedEvent(const FramesRefused &refused);
/// {"event":"vehicle_signing"}: findings from the signatures on the vehicle's side.
std::string vehicleSigningEvent(const VehicleSignatures &signatures);
std::string groundIdClaimedEvent(const GroundIdClaimed &claim);

/// `event` is "stats" or "summary"; `time` is seconds since the start. The channel is that of the agent: tx is sent to
/// the ground.
std::string agentStatsEvent(std::string_view event, const AgentSnapshot &snapshot, double time);

} // namespace skyseal::engine
