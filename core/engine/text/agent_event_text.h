// One sentence for each event of the agent. Channel events read as they do for the station.
#pragma once

#include "core/engine/agent/agent_core.h"
#include "core/engine/text/event_text.h"

namespace skyseal::engine {

/// `names` must have noted the channel event inside.
EventText agentEventText(const AgentEvent &event, const PeerNames &names);

} // namespace skyseal::engine
