// The agent's statistics as scripts read them; its other events have the shapes of event_json.h.
#pragma once

#include "core/engine/agent/agent_event.h"
#include "core/engine/agent/agent_snapshot.h"

#include <string>

namespace skyseal::engine {

/// {"event":"frames_refused"}: what an authenticated peer sent and the vehicle never saw.
std::string framesRefusedEvent(const FramesRefused &refused);

/// `event` is "stats" or "summary"; `time` is seconds since the start. The channel is seen from the agent: tx is what went
/// to the ground.
std::string agentStatsEvent(std::string_view event, const AgentSnapshot &snapshot, double time);

} // namespace skyseal::engine
